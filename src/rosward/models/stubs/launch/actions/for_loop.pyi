# SPDX-License-Identifier: Apache-2.0
"""launch.actions.for_loop."""

from launch.actions import ForEach as ForEach
from launch.actions import ForLoop as ForLoop
