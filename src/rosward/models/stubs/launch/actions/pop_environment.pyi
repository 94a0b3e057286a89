# SPDX-License-Identifier: Apache-2.0
"""launch.actions.pop_environment."""

from launch.actions import PopEnvironment as PopEnvironment
