# SPDX-License-Identifier: Apache-2.0
"""rclpy.exceptions: `*args` as up to jazzy, the names as since kilted.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

class NotInitializedException(Exception):
    def __init__(self, message=None, *args) -> None: ...


class NoTypeSupportImportedException(Exception):
    def __init__(self, *args) -> None: ...


class NameValidationException(Exception):
    def __init__(self, name_type, name, error_msg, invalid_index, *args) -> None: ...


class InvalidHandle(Exception): ...


class TimerCancelledError(Exception): ...


class InvalidNamespaceException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None: ...


class InvalidNodeNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None: ...


class InvalidTopicNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None: ...


class InvalidServiceNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None: ...


class ParameterException(Exception):
    def __init__(self, error_msg, parameters, *args) -> None: ...


class ParameterNotDeclaredException(ParameterException):
    def __init__(self, parameters, *args) -> None: ...


class ParameterAlreadyDeclaredException(ParameterException):
    def __init__(self, parameters, *args) -> None: ...


class InvalidParameterException(ParameterException):
    def __init__(self, parameter_name, *args) -> None: ...


class InvalidParameterTypeException(ParameterException):
    def __init__(self, desired_parameter, expected_type, *args) -> None: ...


class InvalidParameterValueException(ParameterException):
    def __init__(self, parameter, value, reason, *args) -> None: ...


class ParameterImmutableException(ParameterException):
    def __init__(self, parameter_name, *args) -> None: ...


class ParameterUninitializedException(ParameterException):
    def __init__(self, parameter_name, *args) -> None: ...


class ROSInterruptException(Exception):
    def __init__(self, *args) -> None: ...
