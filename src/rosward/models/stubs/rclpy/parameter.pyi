# SPDX-License-Identifier: Apache-2.0
"""rclpy.parameter: a name and a value; all that reads the value gives the value.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from array import array
from enum import IntEnum

from _rosward import array_type, fail_unless, field_of, reads_only, unknown
from rcl_interfaces.msg import Parameter as ParameterMsg

PARAMETER_SEPARATOR_STRING = "."


class _ParameterValue:
    """Stands for rcl_interfaces/msg/ParameterValue: the field of its type holds the value, the others what a new message has."""

    def __init__(self, value):
        self.type = Parameter.Type.from_parameter_value(value)
        self.bool_value = field_of(value, "bool", False)
        self.integer_value = field_of(value, "integer", 0)
        self.double_value = field_of(value, "double", 0.0)
        self.string_value = field_of(value, "string", "")
        self.byte_array_value = field_of(value, "byte_array", [])
        self.bool_array_value = field_of(value, "bool_array", [])
        self.integer_array_value = field_of(value, "integer_array", [])
        self.double_array_value = field_of(value, "double_array", [])
        self.string_array_value = field_of(value, "string_array", [])


class Parameter:
    class Type(IntEnum):
        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, parameter_value):
            if parameter_value is None:
                return Parameter.Type.NOT_SET
            if isinstance(parameter_value, bool):
                return Parameter.Type.BOOL
            if isinstance(parameter_value, int):
                return Parameter.Type.INTEGER
            if isinstance(parameter_value, float):
                return Parameter.Type.DOUBLE
            if isinstance(parameter_value, str):
                return Parameter.Type.STRING
            return getattr(Parameter.Type, array_type(parameter_value))

        def check(self, parameter_value):
            if self == Parameter.Type.NOT_SET:
                return parameter_value is None
            if self == Parameter.Type.BOOL:
                return isinstance(parameter_value, bool)
            if self == Parameter.Type.INTEGER:
                return isinstance(parameter_value, int)
            if self == Parameter.Type.DOUBLE:
                return isinstance(parameter_value, float)
            if self == Parameter.Type.STRING:
                return isinstance(parameter_value, str)
            return isinstance(parameter_value, (list, tuple, array))

    def __init__(self, name, type_=None, value=None):
        if isinstance(type_, Parameter.Type):
            fail_unless(type_.check(value), ValueError, f"parameter {name!r} is of type {type_.name}, its value is not: ValueError")
        self._name = name
        self._type = type_
        self._value = value

    @classmethod
    def from_parameter_msg(cls, param_msg):
        return cls(param_msg.name, None, unknown("message", "value of a parameter"))

    @property
    def name(self):
        return self._name

    @property
    def type_(self):
        if self._type is None:
            return Parameter.Type.from_parameter_value(self._value)
        return self._type

    @property
    def value(self):
        return self._value

    def get_parameter_value(self):
        return _ParameterValue(self._value)

    @reads_only
    def to_parameter_msg(self) -> ParameterMsg: ...


def get_parameter_value(string_value):
    return _ParameterValue(unknown("input", "parameter value parsed from text"))


def parameter_value_to_python(parameter_value):
    return unknown("message", "value of a parameter")


def parameter_dict_from_yaml_file(parameter_file, use_wildcard=False, target_nodes=None, namespace=""):
    return unknown("file", "parameter file")
