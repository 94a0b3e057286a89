# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_process_exit."""

from launch.event_handlers import OnProcessExit as OnProcessExit
