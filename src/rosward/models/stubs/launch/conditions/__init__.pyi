# SPDX-License-Identifier: Apache-2.0
"""launch.conditions.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward.launch import evaluate, keep
from launch.condition import Condition


class InvalidConditionExpressionError(ValueError): ...


class IfCondition(Condition):
    def __init__(self, predicate_expression):
        keep(self, None, predicate=predicate_expression)


class UnlessCondition(IfCondition): ...


class LaunchConfigurationEquals(Condition):
    def __init__(self, launch_configuration_name, expected_value):
        keep(self, None, name=launch_configuration_name, value=expected_value)


class LaunchConfigurationNotEquals(LaunchConfigurationEquals): ...


def evaluate_condition_expression(context, expression):
    return evaluate(IfCondition(expression))
