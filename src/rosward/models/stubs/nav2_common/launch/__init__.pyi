# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch: substitutions that write parameter files, or ask for what is in them.

Read from nav2_common 1.3 and the main branch (a3a9704).
"""

from _rosward import unknown
from _rosward.launch import keep
from launch.substitution import Substitution


class RewrittenYaml(Substitution):
    def __init__(self, source_file, param_rewrites={}, root_key=None, key_rewrites=None, value_rewrites=None, convert_types=False, out_dir=None):
        keep(self, None, path=source_file, rewrites=param_rewrites, root_key=root_key, key_rewrites=key_rewrites,
             value_rewrites=value_rewrites, convert_types=convert_types)


class ReplaceString(Substitution):
    def __init__(self, source_file, replacements, condition=None):
        keep(self, None, path=source_file, replacements=replacements, test=condition)


class HasNodeParams(Substitution):
    def __init__(self, source_file, node_name):
        keep(self, None, path=source_file, node=node_name)


class LaunchConfigAsBool(Substitution):
    def __init__(self, name):
        keep(self, None, name=name)


class ParseMultiRobotPose:
    def __init__(self, target_argument):
        self.target = target_argument

    def value(self): return unknown("argument", self.target, "dict")
