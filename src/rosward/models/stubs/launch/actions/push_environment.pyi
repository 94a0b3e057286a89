# SPDX-License-Identifier: Apache-2.0
"""launch.actions.push_environment."""

from launch.actions import PushEnvironment as PushEnvironment
