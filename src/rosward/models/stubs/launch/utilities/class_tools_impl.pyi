# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.class_tools_impl."""

from launch.utilities import is_a as is_a
