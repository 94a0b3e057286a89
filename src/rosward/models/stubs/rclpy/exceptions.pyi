# SPDX-License-Identifier: Apache-2.0
"""rclpy.exceptions: `*args` as up to jazzy, the names as since kilted; what each of them says.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only

class NotInitializedException(Exception):
    def __init__(self, message=None, *args) -> None:
        told = 'rclpy.init() has not been called'
        super().__init__(f'{told}. msg:{message}' if message else f'{told}.', *args)


class NoTypeSupportImportedException(Exception):
    def __init__(self, *args) -> None:
        super().__init__('no type_support imported', *args)


class NameValidationException(Exception):
    def __init__(self, name_type, name, error_msg, invalid_index, *args) -> None:
        mark = ' ' * (invalid_index + 3) + '^'
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n{mark}", *args)


class InvalidHandle(Exception): ...


class TimerCancelledError(Exception): ...


class InvalidNamespaceException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None:
        super().__init__('namespace', name, error_msg, invalid_index, *args)


class InvalidNodeNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None:
        super().__init__('node name', name, error_msg, invalid_index, *args)


class InvalidTopicNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None:
        super().__init__('topic name', name, error_msg, invalid_index, *args)


class InvalidServiceNameException(NameValidationException):
    def __init__(self, name, error_msg, invalid_index, *args) -> None:
        super().__init__('service name', name, error_msg, invalid_index, *args)


class ParameterException(Exception):
    def __init__(self, error_msg, parameters, *args) -> None:
        super().__init__(f'{error_msg}: {parameters}', *args)


class ParameterNotDeclaredException(ParameterException):
    def __init__(self, parameters, *args) -> None:
        super().__init__('Invalid access to undeclared parameter(s)', parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    def __init__(self, parameters, *args) -> None:
        super().__init__('Parameter(s) already declared', parameters, *args)


class InvalidParameterException(ParameterException):
    def __init__(self, parameter_name, *args) -> None:
        super().__init__('Invalid parameter name', parameter_name, *args)


@reads_only
class InvalidParameterTypeException(ParameterException):
    def __init__(self, desired_parameter, expected_type, *args) -> None: ...


class InvalidParameterValueException(ParameterException):
    def __init__(self, parameter, value, reason, *args) -> None:
        super().__init__(f'Invalid parameter value ({value}) for parameter. Reason: {reason}', parameter, *args)


class ParameterImmutableException(ParameterException):
    def __init__(self, parameter_name, *args) -> None:
        super().__init__('Attempted to modify read-only parameter', parameter_name, *args)


class ParameterUninitializedException(ParameterException):
    def __init__(self, parameter_name, *args) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name, *args)


class ROSInterruptException(Exception):
    def __init__(self, *args) -> None:
        super().__init__('rclpy.shutdown() has been called', *args)
