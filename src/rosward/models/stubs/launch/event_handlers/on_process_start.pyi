# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_process_start."""

from launch.event_handlers import OnProcessStart as OnProcessStart
