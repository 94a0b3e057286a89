# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.path_join_substitution."""

from launch.substitutions import PathJoinSubstitution as PathJoinSubstitution
from launch.substitutions import PathSubstitution as PathSubstitution
