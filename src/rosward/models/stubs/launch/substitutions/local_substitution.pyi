# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.local_substitution."""

from launch.substitutions import LocalSubstitution as LocalSubstitution
