# SPDX-License-Identifier: Apache-2.0
"""The form in which the records of a result are kept: places, findings, nodes with all that they have, what launch files start.

The fields of each record stand here in its own order, so that a field that is new is an error at once and not a loss.
"""

from __future__ import annotations

from typing import Final

from rosward.cache.codec import (
    FLAG,
    LINES,
    NUMBER,
    OPTION,
    PLAIN,
    TEXT,
    maybe,
    one_of,
    pair,
    record,
    sequence,
    told_apart,
)
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.asked import Asked, LaunchAsked
from rosward.network.graph import Action, Network, Service, Topic
from rosward.network.launch_tree import GivenParameter, Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.ros.entities import Entity, EntityKind, Interface, Node, Parameter, Qos, Resolution
from rosward.ros.flows import End, NodeCall, NodeCallback, NodeFlows, NodeSink
from rosward.rules import RULES

PLACE: Final = record(Place, TEXT, NUMBER, NUMBER)
PLACES: Final = sequence(PLACE)
FINDING: Final = record(
    Finding, told_apart(TEXT, RULES.__contains__), TEXT, PLACE, LINES, LINES, TEXT, PLACES, LINES
)  # code, message, place, causes, nodes, remedy, path, doubts
FINDINGS: Final = sequence(FINDING)

# Nodes

QOS: Final = record(Qos, reliability=maybe(TEXT), durability=maybe(TEXT), history=maybe(TEXT), depth=maybe(NUMBER))
ENTITY: Final = record(
    Entity,
    kind=one_of(EntityKind),
    name=TEXT,
    type=maybe(TEXT),
    system=FLAG,
    resolution=one_of(Resolution),
    conditional=FLAG,
    callback=maybe(TEXT),
    qos=maybe(QOS),
    depends_on=LINES,
    created_at=PLACES,
    reasons=LINES,
    causes=LINES,
    via=maybe(TEXT),
    ros_prefix=FLAG,
    path=PLACES,
)
PARAMETER: Final = record(Parameter, name=TEXT, type=maybe(TEXT), default=PLAIN, value=PLAIN, declared_at=maybe(PLACE))
END: Final = record(End, TEXT, TEXT)
_ENDS: Final = sequence(END)
CALL: Final = record(NodeCall, PLACES, _ENDS, _ENDS, _ENDS)  # through, data, control, trigger
SINK: Final = record(
    NodeSink,
    sink=END,
    at=PLACE,
    data=_ENDS,
    control=_ENDS,
    trigger=_ENDS,
    assumed=_ENDS,
    paths=sequence(pair(END, PLACES)),
    calls=sequence(CALL),
)
_SINKS: Final = sequence(SINK)
CALLBACK: Final = record(
    NodeCallback, events=_ENDS, function=TEXT, at=PLACE, sends=sequence(pair(END, _ENDS)), period=maybe(NUMBER)
)
FLOWS: Final = record(
    NodeFlows, sinks=_SINKS, complete=FLAG, executed=_SINKS, released=_SINKS, callbacks=sequence(CALLBACK)
)
NODE: Final = record(
    Node,
    namespace=TEXT,
    name=TEXT,
    resolution=one_of(Resolution),
    enclave=TEXT,
    package=maybe(TEXT),
    executable=maybe(TEXT),
    process=TEXT,
    launched_by=maybe(PLACE),
    defined_at=PLACE,
    entities=sequence(ENTITY),
    parameters=sequence(PARAMETER),
    reasons=LINES,
    given_enclave=maybe(TEXT),
    conditional=FLAG,
    assumed=FLAG,
    causes=LINES,
    interface=one_of(Interface),
    lacks=LINES,
    label=maybe(TEXT),
    flows=maybe(FLOWS),
)
NODES: Final = sequence(NODE)

# The network

_PAIRS: Final = sequence(pair(TEXT, TEXT))
LAUNCH_ASKED: Final = record(LaunchAsked, TEXT, _PAIRS)
ASKED: Final = record(
    Asked, LINES, sequence(LAUNCH_ASKED), FLAG, _PAIRS, LINES, LINES, _PAIRS, sequence(pair(TEXT, OPTION)), TEXT
)  # paths, launch, all_launch, arguments, nodes, parameter_files, environment, options, models
TOPIC: Final = record(Topic, name=TEXT, types=LINES, publishers=LINES, subscriptions=LINES, system=FLAG)
SERVICE: Final = record(Service, name=TEXT, types=LINES, servers=LINES, clients=LINES, system=FLAG)
ACTION: Final = record(Action, name=TEXT, types=LINES, servers=LINES, clients=LINES, system=FLAG)
NETWORK: Final = record(
    Network,
    distro=TEXT,
    nodes=NODES,
    topics=sequence(TOPIC),
    services=sequence(SERVICE),
    actions=sequence(ACTION),
    findings=FINDINGS,
    files=NUMBER,
    lines=NUMBER,
    processes=NUMBER,
    asked=ASKED,
)

# What launch files start

SHOWN: Final = record(Shown, TEXT, TEXT)
GIVEN: Final = record(GivenParameter, TEXT, TEXT, SHOWN, TEXT, maybe(PLACE))  # kind, name, value, scope, place
INCLUSION: Final = record(Inclusion, PLACE, TEXT, NUMBER)
LAUNCH_ENTRY: Final = record(
    LaunchEntry,
    TEXT,  # kind
    maybe(SHOWN),  # package
    maybe(SHOWN),  # executable
    maybe(SHOWN),  # plugin
    maybe(SHOWN),  # container
    maybe(SHOWN),  # name
    maybe(SHOWN),  # namespace
    sequence(pair(SHOWN, SHOWN)),  # remaps
    sequence(GIVEN),  # parameters
    sequence(SHOWN),  # words
    sequence(pair(TEXT, SHOWN)),  # environment
    PLACE,
    sequence(INCLUSION),  # trail
    TEXT,  # program
    FLAG,  # conditional
    LINES,  # why
    TEXT,  # event
)
LAUNCH_SYSTEM: Final = record(LaunchSystem, TEXT, TEXT, sequence(LAUNCH_ENTRY))  # name, file, entries
SYSTEMS: Final = sequence(LAUNCH_SYSTEM)
