# SPDX-License-Identifier: Apache-2.0
"""launch_param_builder.utils."""

from launch_param_builder import ParameterValueType as ParameterValueType
from launch_param_builder import get_package_path as get_package_path
from launch_param_builder import load_file as load_file
from launch_param_builder import load_xacro as load_xacro
from launch_param_builder import load_yaml as load_yaml
from launch_param_builder import raise_if_file_not_found as raise_if_file_not_found
