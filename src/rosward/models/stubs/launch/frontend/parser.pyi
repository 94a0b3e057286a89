# SPDX-License-Identifier: Apache-2.0
"""launch.frontend.parser."""

from launch.frontend import Parser as Parser
