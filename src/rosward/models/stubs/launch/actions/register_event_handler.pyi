# SPDX-License-Identifier: Apache-2.0
"""launch.actions.register_event_handler."""

from launch.actions import RegisterEventHandler as RegisterEventHandler
