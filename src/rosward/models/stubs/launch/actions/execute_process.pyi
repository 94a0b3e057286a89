# SPDX-License-Identifier: Apache-2.0
"""launch.actions.execute_process."""

from launch.actions import ExecuteProcess as ExecuteProcess
