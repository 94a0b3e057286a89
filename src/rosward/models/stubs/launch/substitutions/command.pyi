# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.command."""

from launch.substitutions import Command as Command
