# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.perform_substitutions_impl."""

from launch.utilities import perform_substitutions as perform_substitutions
