# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.unless_condition."""

from launch.conditions import UnlessCondition as UnlessCondition
