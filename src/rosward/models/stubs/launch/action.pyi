# SPDX-License-Identifier: Apache-2.0
"""launch.action: the base of all actions.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import keep
from launch.launch_description_entity import LaunchDescriptionEntity


class Unchanged(LaunchDescriptionEntity):
    """An action as its own library executes it: what `super().execute(context)` gives in a class derived from it."""

    def __init__(self, action):
        keep(self, None, action=action)


class Action(LaunchDescriptionEntity):
    def __init__(self, *, condition=None, **kwargs):
        self.condition = condition
        keep(self, kwargs, condition=condition)

    def get_sub_entities(self): return []

    def visit(self, context):
        return self.execute(context)

    def execute(self, context):
        return [Unchanged(self)]

    @staticmethod
    @reads_only
    def parse(entity, parser): ...
