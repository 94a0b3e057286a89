# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.equals_substitution."""

from launch.substitutions import EqualsSubstitution as EqualsSubstitution
