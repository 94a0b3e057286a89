# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description: the list of what is started.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import keep
from launch.launch_description_entity import LaunchDescriptionEntity


class LaunchDescription(LaunchDescriptionEntity):
    def __init__(self, initial_entities=None, *, deprecated_reason=None):
        keep(self)
        self.entities = [] if initial_entities is None else list(initial_entities)
        self.deprecated_reason = deprecated_reason

    def add_entity(self, entity):
        self.entities.append(entity)

    def add_action(self, action):
        self.entities.append(action)

    def visit(self, context):
        return self.entities

    def describe_sub_entities(self):
        return self.entities

    @reads_only
    def get_launch_arguments(self, conditional_inclusion=False) -> list: ...
    @reads_only
    def get_launch_arguments_with_include_launch_description_actions(self, conditional_inclusion=False) -> list: ...
    @property
    @reads_only
    def deprecated(self) -> bool: ...
