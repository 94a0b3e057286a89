# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.text_substitution."""

from launch.substitutions import TextSubstitution as TextSubstitution
