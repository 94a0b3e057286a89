# SPDX-License-Identifier: Apache-2.0
"""launch.actions.shutdown_action."""

from launch.actions import Shutdown as Shutdown
