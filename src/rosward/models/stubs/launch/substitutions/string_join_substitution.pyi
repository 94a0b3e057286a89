# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.string_join_substitution."""

from launch.substitutions import StringJoinSubstitution as StringJoinSubstitution
