# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.if_condition."""

from launch.conditions import IfCondition as IfCondition
