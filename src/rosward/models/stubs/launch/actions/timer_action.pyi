# SPDX-License-Identifier: Apache-2.0
"""launch.actions.timer_action."""

from launch.actions import TimerAction as TimerAction
