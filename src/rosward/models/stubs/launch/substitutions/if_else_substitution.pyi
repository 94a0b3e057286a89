# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.if_else_substitution."""

from launch.substitutions import IfElseSubstitution as IfElseSubstitution
