# SPDX-License-Identifier: Apache-2.0
"""rosward: from the source of a ROS 2 system to its computation graph and SROS2 policies.

import rosward

result = rosward.extract("my_ws")
for node in result.network.nodes:
    print(node.fqn, [e.name for e in node.entities])
"""

from rosward._version import __version__
from rosward.engine.budget import Budget
from rosward.findings import Finding, Rule, Severity
from rosward.network.graph import Action, Network, Service, Topic
from rosward.pipeline import NothingToReadError, Result, extract
from rosward.ros.entities import Entity, EntityKind, Node, Parameter, Qos, Resolution
from rosward.source.location import Place

__all__ = [
    "Action",
    "Budget",
    "Entity",
    "EntityKind",
    "Finding",
    "Network",
    "Node",
    "NothingToReadError",
    "Parameter",
    "Place",
    "Qos",
    "Resolution",
    "Result",
    "Rule",
    "Service",
    "Severity",
    "Topic",
    "__version__",
    "extract",
]
