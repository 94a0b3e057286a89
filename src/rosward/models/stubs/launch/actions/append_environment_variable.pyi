# SPDX-License-Identifier: Apache-2.0
"""launch.actions.append_environment_variable."""

from launch.actions import AppendEnvironmentVariable as AppendEnvironmentVariable
