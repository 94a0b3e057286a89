# SPDX-License-Identifier: Apache-2.0
"""rosward: from the source of a ROS 2 system to its computation graph and SROS2 policies.

import rosward

result = rosward.extract("my_ws")
for node in result.network.nodes:
    print(node.fqn, [e.name for e in node.entities])
"""

from __future__ import annotations

import importlib

from rosward._version import __version__

TYPE_CHECKING = False  # not from typing: what says again what it said before loads little
if TYPE_CHECKING:
    from typing import Final

    from rosward.engine.budget import Budget
    from rosward.findings import Finding
    from rosward.location import Place
    from rosward.network.graph import Action, Network, Service, Topic
    from rosward.one_cause import OneCause, by_cause
    from rosward.pipeline import NothingToReadError, RequestError, Result, UnknownRequestError, extract
    from rosward.ros.entities import Entity, EntityKind, Node, Parameter, Qos, Resolution
    from rosward.rules import Rule, Severity
    from rosward.surveying.executing import LostExecutorError
    from rosward.surveying.run import Survey, SurveyError, survey

__all__ = [
    "Action",
    "Budget",
    "Entity",
    "EntityKind",
    "Finding",
    "LostExecutorError",
    "Network",
    "Node",
    "NothingToReadError",
    "OneCause",
    "Parameter",
    "Place",
    "Qos",
    "RequestError",
    "Resolution",
    "Result",
    "Rule",
    "Service",
    "Severity",
    "Survey",
    "SurveyError",
    "Topic",
    "UnknownRequestError",
    "__version__",
    "by_cause",
    "extract",
    "survey",
]

_WHERE: Final = {
    "Action": "rosward.network.graph",
    "Budget": "rosward.engine.budget",
    "Entity": "rosward.ros.entities",
    "EntityKind": "rosward.ros.entities",
    "Finding": "rosward.findings",
    "LostExecutorError": "rosward.surveying.executing",
    "Network": "rosward.network.graph",
    "Node": "rosward.ros.entities",
    "NothingToReadError": "rosward.pipeline",
    "OneCause": "rosward.one_cause",
    "Parameter": "rosward.ros.entities",
    "Place": "rosward.location",
    "Qos": "rosward.ros.entities",
    "RequestError": "rosward.pipeline",
    "Resolution": "rosward.ros.entities",
    "Result": "rosward.pipeline",
    "Rule": "rosward.rules",
    "Service": "rosward.network.graph",
    "Severity": "rosward.rules",
    "Survey": "rosward.surveying.run",
    "SurveyError": "rosward.surveying.run",
    "Topic": "rosward.network.graph",
    "UnknownRequestError": "rosward.pipeline",
    "by_cause": "rosward.one_cause",
    "extract": "rosward.pipeline",
    "survey": "rosward.surveying.run",
}


def __getattr__(name: str) -> object:
    """The public names, each loaded when it is first used: the command line answers at once."""
    if name not in _WHERE:
        raise AttributeError(f"module 'rosward' has no attribute {name!r}")
    return getattr(importlib.import_module(_WHERE[name]), name)


def __dir__() -> list[str]:
    """The public names, also those that nobody has used yet."""
    return sorted({*__all__, *(name for name in globals() if name.startswith("__"))})
