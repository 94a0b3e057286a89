# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_shutdown."""

from launch.event_handlers import OnShutdown as OnShutdown
