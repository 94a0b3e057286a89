# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.invalid_condition_expression_error."""

from launch.conditions import InvalidConditionExpressionError as InvalidConditionExpressionError
