# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.ensure_argument_type_impl."""

from launch.utilities import ensure_argument_type as ensure_argument_type
