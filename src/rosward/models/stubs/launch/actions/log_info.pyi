# SPDX-License-Identifier: Apache-2.0
"""launch.actions.log_info."""

from launch.actions import LogInfo as LogInfo
