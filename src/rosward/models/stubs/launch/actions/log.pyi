# SPDX-License-Identifier: Apache-2.0
"""launch.actions.log."""

from launch.actions import Log as Log
