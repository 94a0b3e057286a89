# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.boolean_substitution."""

from launch.substitutions import NotSubstitution as NotSubstitution
from launch.substitutions import AndSubstitution as AndSubstitution
from launch.substitutions import OrSubstitution as OrSubstitution
from launch.substitutions import AnySubstitution as AnySubstitution
from launch.substitutions import AllSubstitution as AllSubstitution
