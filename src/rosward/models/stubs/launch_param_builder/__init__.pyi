# SPDX-License-Identifier: Apache-2.0
"""launch_param_builder: parameters that are put together from files.

Read from launch_param_builder 0.1.
"""

import yaml
from _rosward import reads_only, unknown
from ament_index_python.packages import get_package_share_directory
from pathlib import Path


class ParameterValueType: ...
class ParameterBuilderFileNotFoundError(KeyError): ...


class ParameterBuilder:
    def __init__(self, package_name):
        self._package_path = Path(get_package_share_directory(package_name))
        self._parameters = {}

    def yaml(self, file_path, parameter_namespace=None):
        found = load_yaml(self._package_path / file_path)
        if not parameter_namespace:
            self._parameters.update(found)
        elif parameter_namespace in self._parameters:
            self._parameters[parameter_namespace].update(found)
        else:
            self._parameters[parameter_namespace] = found
        return self

    def file_parameter(self, parameter_name, file_path):
        self._parameters[parameter_name] = load_file(self._package_path / file_path)
        return self

    def path_parameter(self, parameter_name, file_path):
        self._parameters[parameter_name] = str(self._package_path / file_path)
        return self

    def xacro_parameter(self, parameter_name, file_path, mappings=None):
        self._parameters[parameter_name] = load_xacro(self._package_path / file_path)
        return self

    def parameter(self, parameter_name, parameter_value):
        self._parameters[parameter_name] = parameter_value
        return self

    def parameters(self, parameters, parameter_namespace=None):
        self._parameters.update({parameter_namespace: parameters} if parameter_namespace else parameters)
        return self

    def to_dict(self): return self._parameters


def get_package_path(package_name): return Path(get_package_share_directory(package_name))
def get_path(package_name, file_path): return str(Path(get_package_share_directory(package_name)) / file_path)


def load_file(file_path):
    with open(file_path) as file:
        return file.read()


def load_yaml(file_path):
    with open(file_path) as file:
        return yaml.safe_load(file)


def load_xacro(file_path, mappings=None): return unknown("file", str(file_path), "str")
@reads_only
def raise_if_file_not_found(file_path) -> None: ...
