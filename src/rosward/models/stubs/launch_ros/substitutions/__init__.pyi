# SPDX-License-Identifier: Apache-2.0
"""launch_ros.substitutions.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward.launch import keep
from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch.substitution import Substitution
from launch.substitutions import PathJoinSubstitution


class FindPackage(Substitution):
    def __init__(self, package):
        self.package = package
        keep(self, None, package=package)

    def __truediv__(self, other):
        return PathJoinSubstitution([self, other])


class FindPackagePrefix(FindPackage):
    def find(self, package_name):
        return get_package_prefix(package_name)


class FindPackageShare(FindPackage):
    def find(self, package_name):
        return get_package_share_directory(package_name)


class ExecutableInPackage(FindPackagePrefix):
    def __init__(self, executable, package):
        super().__init__(package)
        self.executable = executable
        keep(self, None, executable=executable)


class Parameter(Substitution):
    def __init__(self, name, *, default=None):
        keep(self, None, name=name, default=default)
