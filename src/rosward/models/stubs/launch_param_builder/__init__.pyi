# SPDX-License-Identifier: Apache-2.0
"""launch_param_builder: parameters that are put together from files.

What the files say is not read: all that is built is an unknown dict of parameters.

Read from launch_param_builder 0.1.
"""

from _rosward import reads_only, unknown
from ament_index_python.packages import get_package_share_directory
from pathlib import Path


class ParameterValueType: ...


class ParameterBuilder:
    def __init__(self, package_name):
        self._package = package_name
        self._package_path = Path(get_package_share_directory(package_name))

    def yaml(self, file_path, parameter_namespace=None): return self
    def file_parameter(self, parameter_name, file_path): return self
    def xacro_parameter(self, parameter_name, file_path, mappings=None): return self
    def parameter(self, parameter_name, parameter_value): return self
    def parameters(self, parameters, parameter_namespace=None): return self
    def to_dict(self): return unknown("file", "parameters of the package " + self._package, "dict")


def get_package_path(package_name): return Path(get_package_share_directory(package_name))
def load_file(file_path): return unknown("file", str(file_path), "str")
def load_yaml(file_path): return unknown("file", str(file_path), "dict")
def load_xacro(file_path, mappings=None): return unknown("file", str(file_path), "str")
@reads_only
def raise_if_file_not_found(file_path) -> None: ...
