# SPDX-License-Identifier: Apache-2.0
"""py_trees.common.

Read from py_trees 2.6.0.
"""

from _rosward import reads_only

import enum

reads_only(__name__)


class Name(enum.Enum):
    AUTO_GENERATED = "AUTO_GENERATED"


class Status(enum.Enum):
    SUCCESS = "SUCCESS"
    FAILURE = "FAILURE"
    RUNNING = "RUNNING"
    INVALID = "INVALID"


def _tells(seen) -> bool: ...


def _status(*seen):
    """What a behaviour finds, by what it has seen."""
    return Status.SUCCESS if _tells(seen) else Status.FAILURE


class Duration(enum.Enum):
    INFINITE = 1.7976931348623157e308
    UNTIL_THE_BATTLE_OF_ALFREDO = 1.7976931348623157e308


class Access(enum.Enum):
    READ = "READ"
    WRITE = "WRITE"
    EXCLUSIVE_WRITE = "EXCLUSIVE_WRITE"


class ParallelPolicy:
    class Base:
        def __init__(self, synchronise=False) -> None: ...

    class SuccessOnAll(Base):
        def __init__(self, synchronise=True) -> None: ...

    class SuccessOnOne(Base):
        def __init__(self) -> None: ...

    class SuccessOnSelected(Base):
        def __init__(self, children, synchronise=True) -> None: ...


class OneShotPolicy(enum.Enum):
    ON_COMPLETION = "ON_COMPLETION"
    ON_SUCCESSFUL_COMPLETION = "ON_SUCCESSFUL_COMPLETION"


class ClearingPolicy(enum.IntEnum):
    ON_INITIALISE = 1
    ON_SUCCESS = 2
    NEVER = 3


class ComparisonExpression:
    def __init__(self, variable, value, operator):
        self.variable = variable
        self.value = value
        self.operator = operator


class BlackBoxLevel(enum.IntEnum):
    DETAIL = 1
    COMPONENT = 2
    BIG_PICTURE = 3
    NOT_A_BLACKBOX = 4


class VisibilityLevel(enum.IntEnum):
    ALL = 0
    DETAIL = 1
    COMPONENT = 2
    BIG_PICTURE = 3
