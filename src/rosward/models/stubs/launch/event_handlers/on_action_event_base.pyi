# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_action_event_base."""

from launch.event_handlers import OnActionEventBase as OnActionEventBase
