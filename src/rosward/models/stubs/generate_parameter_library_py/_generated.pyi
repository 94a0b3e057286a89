# SPDX-License-Identifier: Apache-2.0
"""What a module that is made of a description of parameters needs, and cannot say in Python."""

from _rosward import fail_unless, overridden, parameter, unknown
from rclpy.exceptions import InvalidParameterValueException

def check(right, name, rule):
    fail_unless(right, InvalidParameterValueException, f"the value of parameter {name!r} is refused by {rule}: InvalidParameterValueException")

def set_by_hand(params):
    return unknown("parameter", "parameters set by set_params_from_dict")

def value(node, name):
    """The value of a parameter, without the object around it: of those, there may be more than are told apart."""
    if overridden(node, "get_parameter"):
        return node.get_parameter(name).value
    return parameter(node, name)
