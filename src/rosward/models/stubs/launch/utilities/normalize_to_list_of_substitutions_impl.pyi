# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.normalize_to_list_of_substitutions_impl."""

from launch.utilities import normalize_to_list_of_substitutions as normalize_to_list_of_substitutions
