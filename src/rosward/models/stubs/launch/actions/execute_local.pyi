# SPDX-License-Identifier: Apache-2.0
"""launch.actions.execute_local."""

from launch.actions import ExecuteLocal as ExecuteLocal
