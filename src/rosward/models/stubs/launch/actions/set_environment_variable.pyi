# SPDX-License-Identifier: Apache-2.0
"""launch.actions.set_environment_variable."""

from launch.actions import SetEnvironmentVariable as SetEnvironmentVariable
