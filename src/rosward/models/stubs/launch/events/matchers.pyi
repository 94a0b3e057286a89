# SPDX-License-Identifier: Apache-2.0
"""launch.events.matchers."""

from launch.events import matches_action as matches_action
