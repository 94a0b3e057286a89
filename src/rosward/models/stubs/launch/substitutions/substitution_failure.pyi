# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.substitution_failure."""

from launch.substitutions import SubstitutionFailure as SubstitutionFailure
