# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.find_executable."""

from launch.substitutions import FindExecutable as FindExecutable
