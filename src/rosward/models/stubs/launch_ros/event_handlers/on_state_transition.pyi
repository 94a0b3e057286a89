# SPDX-License-Identifier: Apache-2.0
"""launch_ros.event_handlers.on_state_transition."""

from launch_ros.event_handlers import OnStateTransition as OnStateTransition
