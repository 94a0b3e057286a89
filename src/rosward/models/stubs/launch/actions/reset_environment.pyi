# SPDX-License-Identifier: Apache-2.0
"""launch.actions.reset_environment."""

from launch.actions import ResetEnvironment as ResetEnvironment
