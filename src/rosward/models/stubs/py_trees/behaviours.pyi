# SPDX-License-Identifier: Apache-2.0
"""py_trees.behaviours.

Read from py_trees 2.6.0.
"""

from py_trees import common
from py_trees.behaviour import Behaviour
from py_trees.blackboard import Blackboard


class Success(Behaviour): ...


class Failure(Behaviour): ...


class Running(Behaviour): ...


class Dummy(Behaviour): ...


class Periodic(Behaviour):
    def __init__(self, name, n):
        Behaviour.__init__(self, name)


class StatusQueue(Behaviour):
    def __init__(self, name, queue, eventually):
        Behaviour.__init__(self, name)
        self.queue = queue
        self.eventually = eventually

    def update(self):
        return common._status(self.queue, self.eventually)


class SuccessEveryN(Behaviour):
    def __init__(self, name, n):
        Behaviour.__init__(self, name)


class TickCounter(Behaviour):
    def __init__(self, name, duration, completion_status):
        Behaviour.__init__(self, name)


class BlackboardToStatus(Behaviour):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)
        self.variable_name = variable_name

    def update(self):
        return common._status(Blackboard.get(self.variable_name))


class CheckBlackboardVariableExists(Behaviour):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)
        self.variable_name = variable_name

    def update(self):
        return common._status(Blackboard.exists(self.variable_name))


class WaitForBlackboardVariable(CheckBlackboardVariableExists):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)


class UnsetBlackboardVariable(Behaviour):
    def __init__(self, name, key):
        Behaviour.__init__(self, name)


class SetBlackboardVariable(Behaviour):
    def __init__(self, name, variable_name, variable_value, overwrite=True):
        Behaviour.__init__(self, name)
        self.variable_name = variable_name
        self.variable_value = variable_value

    def update(self):
        value = self.variable_value
        Blackboard.set(self.variable_name, value() if callable(value) else value)
        return common._status(Blackboard.exists(self.variable_name))


class CheckBlackboardVariableValue(Behaviour):
    def __init__(self, name, check):
        Behaviour.__init__(self, name)
        self.check = check

    def update(self):
        check = self.check
        return common._status(check.operator(Blackboard.get(check.variable), check.value))


class CompareBlackboardVariables(Behaviour):
    def __init__(self, name, var1_key, var2_key, operator):
        Behaviour.__init__(self, name)
        self.var1_key, self.var2_key = var1_key, var2_key
        self.operator = operator

    def update(self):
        return common._status(self.operator(Blackboard.get(self.var1_key), Blackboard.get(self.var2_key)))


class WaitForBlackboardVariableValue(CheckBlackboardVariableValue):
    def __init__(self, name, check):
        Behaviour.__init__(self, name)


class CheckBlackboardVariableValues(Behaviour):
    def __init__(self, name, checks, operator, namespace=None):
        Behaviour.__init__(self, name)


class ProbabilisticBehaviour(Behaviour):
    def __init__(self, name, weights=None):
        Behaviour.__init__(self, name)
