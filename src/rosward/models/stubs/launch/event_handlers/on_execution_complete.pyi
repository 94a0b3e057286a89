# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_execution_complete."""

from launch.event_handlers import OnExecutionComplete as OnExecutionComplete
