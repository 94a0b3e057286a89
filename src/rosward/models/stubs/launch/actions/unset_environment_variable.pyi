# SPDX-License-Identifier: Apache-2.0
"""launch.actions.unset_environment_variable."""

from launch.actions import UnsetEnvironmentVariable as UnsetEnvironmentVariable
