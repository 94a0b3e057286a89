# SPDX-License-Identifier: Apache-2.0
"""py_trees.behaviours.

Read from py_trees 2.6.0.
"""

from py_trees import common
from py_trees.behaviour import Behaviour


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


class SuccessEveryN(Behaviour):
    def __init__(self, name, n):
        Behaviour.__init__(self, name)


class TickCounter(Behaviour):
    def __init__(self, name, duration, completion_status):
        Behaviour.__init__(self, name)


class BlackboardToStatus(Behaviour):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)


class CheckBlackboardVariableExists(Behaviour):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)


class WaitForBlackboardVariable(CheckBlackboardVariableExists):
    def __init__(self, name, variable_name):
        Behaviour.__init__(self, name)


class UnsetBlackboardVariable(Behaviour):
    def __init__(self, name, key):
        Behaviour.__init__(self, name)


class SetBlackboardVariable(Behaviour):
    def __init__(self, name, variable_name, variable_value, overwrite):
        Behaviour.__init__(self, name)


class CheckBlackboardVariableValue(Behaviour):
    def __init__(self, name, check):
        Behaviour.__init__(self, name)


class CompareBlackboardVariables(Behaviour):
    def __init__(self, name, var1_key, var2_key, operator):
        Behaviour.__init__(self, name)


class WaitForBlackboardVariableValue(CheckBlackboardVariableValue):
    def __init__(self, name, check):
        Behaviour.__init__(self, name)


class CheckBlackboardVariableValues(Behaviour):
    def __init__(self, name, checks, operator, namespace=None):
        Behaviour.__init__(self, name)


class ProbabilisticBehaviour(Behaviour):
    def __init__(self, name, weights=None):
        Behaviour.__init__(self, name)
