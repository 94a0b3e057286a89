# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.not_equals_substitution."""

from launch.substitutions import NotEqualsSubstitution as NotEqualsSubstitution
