# SPDX-License-Identifier: Apache-2.0
"""launch_ros.parameter_descriptions.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import reads_only, unknown
from _rosward.launch import keep, perform


class ParameterValue:
    def __init__(self, value, *, value_type=None):
        self.value = value
        self.value_type = value_type
        keep(self, None, value=value, value_type=value_type)

    def evaluate(self, context): return unknown("argument", "parameter")


class Parameter:
    def __init__(self, name, value, *, value_type=None):
        self.name = name
        self.value = value
        self.value_type = value_type
        keep(self, None, name=name, value=value, value_type=value_type)

    def evaluate(self, context): return (perform(self.name), unknown("argument", "parameter"))


class ParameterFile:
    def __init__(self, param_file, *, allow_substs=False):
        self.param_file = param_file
        self.allow_substs = allow_substs
        keep(self, None, path=param_file, allow_substs=allow_substs)

    def evaluate(self, context): return perform(self.param_file)
    @reads_only
    def cleanup(self) -> None: ...
