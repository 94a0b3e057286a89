# SPDX-License-Identifier: Apache-2.0
"""launch.actions.unregister_event_handler."""

from launch.actions import UnregisterEventHandler as UnregisterEventHandler
