# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_process_io."""

from launch.event_handlers import OnProcessIO as OnProcessIO
