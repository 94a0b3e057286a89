# SPDX-License-Identifier: Apache-2.0
"""py_trees.decorators.

Read from py_trees 2.6.0.
"""

import functools
import inspect

from _rosward import reads_only

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard


class Decorator(Behaviour):
    def __init__(self, name, child):
        Behaviour.__init__(self, name)
        self.children = [child]
        self.decorated = child

    def update(self):
        return common._status(self.decorated.status)


class Repeat(Decorator):
    def __init__(self, name, child, num_success):
        Decorator.__init__(self, name, child)


class Retry(Decorator):
    def __init__(self, name, child, num_failures):
        Decorator.__init__(self, name, child)


class StatusToBlackboard(Decorator):
    def __init__(self, name, child, variable_name):
        Decorator.__init__(self, name, child)
        self.variable_name = variable_name

    def update(self):
        Blackboard.set(self.variable_name, self.decorated.status)
        return self.decorated.status


class EternalGuard(Decorator):
    def __init__(self, name, child, condition, blackboard_keys=None):
        Decorator.__init__(self, name, child)
        self.blackboard = self.attach_blackboard_client(name)
        asks = "blackboard" in inspect.signature(condition).parameters
        self.condition = functools.partial(condition, self.blackboard) if asks else condition

    def update(self):
        return common._status(self.condition(), self.decorated.status)


class Timeout(Decorator):
    def __init__(self, name, child, duration=5.0):
        Decorator.__init__(self, name, child)


class Count(Decorator):
    def __init__(self, name, child):
        Decorator.__init__(self, name, child)


class OneShot(Decorator):
    def __init__(self, name, child, policy):
        Decorator.__init__(self, name, child)


class Inverter(Decorator):
    def __init__(self, name, child):
        Decorator.__init__(self, name, child)


class RunningIsFailure(Decorator): ...


class RunningIsSuccess(Decorator): ...


class FailureIsSuccess(Decorator): ...


class FailureIsRunning(Decorator): ...


class SuccessIsFailure(Decorator): ...


class SuccessIsRunning(Decorator): ...


class Condition(Decorator):
    def __init__(self, name, child, status):
        Decorator.__init__(self, name, child)


class PassThrough(Decorator):
    def __init__(self, name, child):
        Decorator.__init__(self, name, child)


class ForEach(Decorator):
    def __init__(self, name, child, source_key, target_key):
        Decorator.__init__(self, name, child)
        self.source_key, self.target_key = source_key, target_key

    def update(self):
        Blackboard.set(self.target_key, _one_of(Blackboard.get(self.source_key)))
        return common._status(self.decorated.status)


@reads_only
def _one_of(several): ...
