# SPDX-License-Identifier: Apache-2.0
"""launch.event_handlers.on_include_launch_description."""

from launch.event_handlers import OnIncludeLaunchDescription as OnIncludeLaunchDescription
from launch.event_handler import EventHandler as EventHandler
from launch.events import IncludeLaunchDescription as IncludeLaunchDescription
