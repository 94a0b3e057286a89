# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.event_named."""

from launch.event_handlers import event_named as event_named
from launch.event import Event as Event
