# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_sources.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from importlib.machinery import SourceFileLoader
from launch.launch_description_source import LaunchDescriptionSource

reads_only(__name__)


class InvalidLaunchFileError(Exception): ...
class InvalidPythonLaunchFileError(Exception): ...
class InvalidFrontendLaunchFileError(Exception): ...


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    def __init__(self, launch_file_path):
        super().__init__(location=launch_file_path)


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    def __init__(self, launch_file_path, *, method="interpreted frontend launch file", parser=None):
        super().__init__(location=launch_file_path)


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    def __init__(self, launch_file_path):
        super().__init__(location=launch_file_path)


def get_launch_description_from_any_launch_file(launch_file_path, *, parser=None): ...
def get_launch_description_from_frontend_launch_file(frontend_launch_file_path, *, parser=None): ...
def get_launch_description_from_python_launch_file(python_launch_file_path):
    return load_python_launch_file_as_module(python_launch_file_path).generate_launch_description()
def load_python_launch_file_as_module(python_launch_file_path):
    return SourceFileLoader("python_launch_file", python_launch_file_path).load_module()
