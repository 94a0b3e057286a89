# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.environment_variable."""

from launch.substitutions import EnvironmentVariable as EnvironmentVariable
