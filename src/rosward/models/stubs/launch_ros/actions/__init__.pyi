# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import REQUIRED, keep
from launch.action import Action
from launch.actions import ExecuteProcess, TimerAction


@reads_only
class Node(ExecuteProcess):
    def __init__(self, *, executable=REQUIRED, package=None, name=None, namespace=None, exec_name=None, parameters=None,
                 remappings=None, ros_arguments=None, arguments=None, **kwargs):
        keep(self, None, executable=executable, package=package, name=name, namespace=namespace, parameters=parameters,
             remappings=remappings, ros_arguments=ros_arguments, arguments=arguments)
        super().__init__(cmd=None, name=exec_name, **kwargs)

    @property
    def node_package(self): ...
    @property
    def node_executable(self): ...
    @property
    def node_name(self) -> str: ...
    @property
    def expanded_node_namespace(self) -> str: ...
    def is_node_name_fully_specified(self) -> bool: ...


class LifecycleNode(Node):
    def __init__(self, *, name=REQUIRED, namespace=REQUIRED, autostart=False, **kwargs):
        super().__init__(name=name, namespace=namespace, **kwargs)


class ComposableNodeContainer(Node):
    def __init__(self, *, name=REQUIRED, namespace=REQUIRED, composable_node_descriptions=None, **kwargs):
        keep(self, None, composable_node_descriptions=composable_node_descriptions)
        super().__init__(name=name, namespace=namespace, **kwargs)


class LoadComposableNodes(Action):
    def __init__(self, *, composable_node_descriptions=REQUIRED, target_container=REQUIRED, **kwargs):
        keep(self, None, composable_node_descriptions=composable_node_descriptions, target=target_container)
        super().__init__(**kwargs)


class LifecycleTransition(Action):
    def __init__(self, *, lifecycle_node_names=REQUIRED, transition_ids=REQUIRED, **kwargs):
        super().__init__(**kwargs)


class PushROSNamespace(Action):
    def __init__(self, namespace, **kwargs):
        keep(self, None, namespace=namespace)
        super().__init__(**kwargs)


PushRosNamespace = PushROSNamespace


class ROSTimer(TimerAction): ...


RosTimer = ROSTimer


class SetParameter(Action):
    def __init__(self, name, value, **kwargs):
        keep(self, None, name=name, value=value)
        super().__init__(**kwargs)


class SetParametersFromFile(Action):
    def __init__(self, filename, **kwargs):
        keep(self, None, path=filename)
        super().__init__(**kwargs)


class SetRemap(Action):
    def __init__(self, src, dst, **kwargs):
        keep(self, None, source=src, target=dst)
        super().__init__(**kwargs)


class SetROSLogDir(Action):
    def __init__(self, new_log_dir, **kwargs):
        super().__init__(**kwargs)


class SetUseSimTime(Action):
    def __init__(self, value, **kwargs):
        keep(self, None, value=value)
        super().__init__(**kwargs)
