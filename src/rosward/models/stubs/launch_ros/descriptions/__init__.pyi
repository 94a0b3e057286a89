# SPDX-License-Identifier: Apache-2.0
"""launch_ros.descriptions.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward.launch import REQUIRED, keep
from launch_ros.parameter_descriptions import Parameter as Parameter
from launch_ros.parameter_descriptions import ParameterFile as ParameterFile
from launch_ros.parameter_descriptions import ParameterValue as ParameterValue


class ComposableNode:
    def __init__(self, *, package=REQUIRED, plugin=REQUIRED, name=None, namespace=None, parameters=None, remappings=None,
                 extra_arguments=None, condition=None, **kwargs):
        self.package = package
        self.node_plugin = plugin
        self.node_name = name
        self.node_namespace = namespace
        self.parameters = parameters
        self.remappings = remappings
        self.extra_arguments = extra_arguments
        keep(self, None, package=package, plugin=plugin, name=name, namespace=namespace, parameters=parameters,
             remappings=remappings, extra_arguments=extra_arguments, condition=condition)
        keep(self, kwargs)
