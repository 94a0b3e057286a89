# SPDX-License-Identifier: Apache-2.0
"""launch.events.shutdown."""

from launch.events import Shutdown as Shutdown
