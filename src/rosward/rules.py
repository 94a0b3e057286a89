# SPDX-License-Identifier: Apache-2.0
"""The table of rules: which kinds of findings are there, how much does each weigh, what can be done about it?"""

from __future__ import annotations

from typing import Final

from rosward.rule import Rule, Severity
from rosward.rules_of_systems import LATER

__all__ = ["INTERNAL_ERROR", "KILLED", "RULES", "TIME_LIMIT", "Rule", "Severity"]


_E, _W, _N = Severity.ERROR, Severity.WARNING, Severity.NOTE

_TABLE: Final = (
    # Input
    Rule("RW001", "syntax error", _E, "Fix the file or exclude it. Its content is not in the result."),
    Rule("RW002", "file cannot be read", _E, "Check permissions and links. Its content is not in the result."),
    Rule("RW003", "file too large", _E, "Exclude generated data or split the file. It was not analysed."),
    Rule("RW004", "text encoding", _W, "Declare the encoding (PEP 263) or save the file as UTF-8."),
    Rule("RW005", "nesting too deep", _E, "Simplify the expression. The file was not analysed."),
    Rule("RW006", "Python 2 source", _E, "Port the file to Python 3 or exclude it. Its content is not in the result."),
    Rule("RW007", "no ROS 2 code found", _W, "The result is empty."),
    Rule(
        "RW008",
        "unreadable package description",
        _E,
        "Fix the setup.py, setup.cfg, pyproject.toml or CMakeLists.txt. Executables and modules that it names may be missing.",
    ),
    Rule(
        "RW009",
        "executable without source",
        _W,
        "The entry point names a module or function that is not among the sources.",
    ),
    Rule(
        "RW010",
        "unused ignore comment",
        _N,
        "Remove the comment, or the code from its brackets. It ignores nothing.",
    ),
    Rule(
        "RW011",
        "excluded by pattern",
        _N,
        "It was not read, and what it creates is not in the result. See --exclude.",
    ),
    Rule(
        "RW012",
        "link out of the sources",
        _E,
        "Pass the target folder as a PATH, or use --follow-links. Nothing behind the link is in the result.",
    ),
    Rule(
        "RW013",
        "folder marked as ignored",
        _N,
        "colcon does not build this folder, and it is not in the result. Pass the folder as a PATH to analyse it.",
    ),
    Rule(
        "RW014",
        "duplicate package name",
        _W,
        "colcon rejects two packages with the same name. The result includes both; exclude one of them (--exclude).",
    ),
    Rule(
        "RW015",
        "launch file in an ignored folder",
        _W,
        "colcon does not install the files next to it. Pass its folder as an additional PATH so that its programs are found.",
    ),
    Rule(
        "RW016",
        "executable from another package",
        _E,
        "Add the package of this module to the analysis. What it creates is missing.",
    ),
    Rule("RW017", "invalid package.xml", _W, "Fix it: the ROS tools reject the package. Its folder was still read."),
    Rule("RW018", "C++ cannot be read", _E, "Install the missing packages. No program in C++ is in the result."),
    Rule(
        "RW019",
        "C++ program without its source",
        _E,
        "Add the source of the class or of the function main to the analysis. What the program creates is missing.",
    ),
    Rule("RW020", "package for ROS 1", _W, "rosward reads ROS 2: what runs under ROS 1 is not in the result."),
    # Names and types
    Rule("RW101", "unknown name", _E, "Give the missing value a default in the source."),
    Rule("RW102", "partially known name", _W, "Supply the missing part, or accept the wildcard in the policy."),
    Rule("RW103", "invalid name", _E, "rcl rejects this name, so the call fails at run time."),
    Rule("RW104", "unknown type", _W, "Import the interface type directly, so that it can be named."),
    Rule(
        "RW105",
        "unknown node name",
        _E,
        "Name the node in the source, or give a default to the values that form its name.",
    ),
    Rule(
        "RW106",
        "unknown ROS arguments",
        _E,
        "Write the arguments in the source. Remap rules among them can rename nodes, topics and services.",
    ),
    Rule(
        "RW107",
        "name generated at each start",
        _N,
        "The name cannot be known in advance. The policy uses a pattern, which grants the same to every such name.",
    ),
    Rule(
        "RW108",
        "off by default",
        _W,
        "It exists once somebody sets what the message names. Tell rosward what your system sets (--launch, --params), so that the policy allows it.",
    ),
    # Analysis
    Rule(
        "RW201",
        "limit reached",
        _E,
        "The analysis stopped early here, and what follows is missing from the result. `--budget 4` allows four times as many steps.",
    ),
    Rule(
        "RW202",
        "node or type passed to an unknown library",
        _E,
        "Describe the library in a stub file (--models), or check manually what it creates.",
    ),
    Rule(
        "RW203",
        "code generated at run time",
        _E,
        "exec, eval, dynamic imports and similar constructs are not analysed.",
    ),
    Rule(
        "RW204",
        "called from outside the sources",
        _E,
        "A library or a loader of plugins that is not among the sources may run this. Add it to the analysis, or describe it (--models).",
    ),
    Rule("RW205", "entity in unreachable code", _N, "No entry point reaches this call, so it is not in the result."),
    Rule(
        "RW206",
        "unsupported construct",
        _E,
        "What it creates is missing from the result. Please report it, or exclude a library that knows nothing of ROS (--exclude).",
    ),
    Rule(
        "RW207",
        "module not among the sources",
        _E,
        "Add its package to the analysis, or install it next to the workspace.",
    ),
    Rule(
        "RW208",
        "entity on an unknown node",
        _E,
        "The node that this call belongs to is unknown, so the entity is in no policy.",
    ),
    Rule(
        "RW209",
        "call fails at run time",
        _W,
        "The call raises an exception when the program runs. Correct the call, or what it is given.",
    ),
    Rule(
        "RW210",
        "starts another program",
        _E,
        "The program started here is not in the result. Analyse it or declare it.",
    ),
    Rule("RW211", "starts a ROS tool", _N, "Command-line tools are not part of the system."),
    Rule(
        "RW212",
        "entity in code that may run",
        _E,
        "Unknown code may call it. Make its caller, or the object it is called on, known to the analysis.",
    ),
    Rule(
        "RW213",
        "message of the wrong type",
        _W,
        "The client library raises TypeError here: send the type that the entity was created with.",
    ),
    Rule(
        "RW214",
        "wrong mark in a model",
        _E,
        "Correct it: what it should say is missing from what is known of the library.",
    ),
    Rule(
        "RW299",
        "internal error",
        _E,
        "This is a bug in rosward, not in this file. Please report it, with the file if possible. What the message names is not in the result.",
    ),
    # System and policy
    Rule(
        "RW301",
        "several nodes in one process",
        _W,
        "They share one context and therefore one enclave. Start them with an enclave whose policy has both profiles.",
    ),
    Rule(
        "RW302",
        "wildcard matches more than one name segment",
        _W,
        "In DDS permissions, * also matches /. Make the unknown part known.",
    ),
    Rule(
        "RW303",
        "enclave path too long",
        _W,
        "A certificate cannot hold a path of more than 64 characters. Choose a shorter path when you start the process.",
    ),
    Rule(
        "RW304",
        "permissions too large",
        _W,
        "The DDS handshake fails above about 64 KB. Split the enclave (`rosward enclaves suggest`) or replace names by patterns (`--compact`).",
    ),
    Rule(
        "RW305",
        "topic outside the ROS namespace",
        _E,
        "policy.xml cannot express avoid_ros_namespace_conventions. Write the DDS permission by hand.",
    ),
    Rule(
        "RW306",
        "different types on one name",
        _W,
        "A publisher and a subscription (or a server and a client) with different types never communicate.",
    ),
    Rule("RW307", "duplicate node name", _N, "Two nodes with the same full name share one policy. Rename one of them."),
    Rule(
        "RW308",
        "conflicting enclaves",
        _W,
        "A process has one enclave. Set it in one place only (--enclave or ROS_SECURITY_ENCLAVE_OVERRIDE).",
    ),
    Rule(
        "RW309",
        "incompatible QoS",
        _W,
        "The two never communicate. Let the publisher offer what the subscription requests, or let the subscription request less.",
    ),
    # Deployment
    Rule("RW310", "unreadable launch file", _E, "Fix the launch file. What it starts is not in the result."),
    Rule(
        "RW311",
        "included launch file not found",
        _E,
        "Pass the folder of its package (--underlay). What it starts and sets is not in the result.",
    ),
    Rule("RW312", "launch argument without a value", _E, "Set it on the command line: --arg NAME:=VALUE."),
    Rule(
        "RW313",
        "unknown launch value",
        _W,
        "Set the launch argument or environment variable that it depends on (--arg NAME:=VALUE, --env NAME=VALUE).",
    ),
    Rule(
        "RW314",
        "node with unknown interface",
        _E,
        "Declare its interface. `rosward declare PACKAGE/EXECUTABLE` creates the file, empty or from a running robot or its source (--from).",
    ),
    Rule(
        "RW315",
        "parameter file not found",
        _E,
        "launch continues without it, and so does the analysis. Fix the path, or build what generates the file.",
    ),
    Rule(
        "RW316",
        "unknown launch condition",
        _N,
        "Both branches are analysed. Decide it with --arg NAME:=VALUE or --env NAME=VALUE.",
    ),
    Rule("RW317", "unreadable parameter file", _E, "rcl rejects this file, so the node fails at startup."),
    Rule(
        "RW318",
        "component without its container",
        _W,
        "Nothing starts the container that this component is loaded into. It is analysed as if something did.",
    ),
    Rule("RW319", "program not known as a node", _E, "If it communicates over ROS, declare its interface (--models)."),
    Rule(
        "RW320",
        "launch fails here",
        _W,
        "The real launch stops here, or the process fails at startup. The result also includes what would follow.",
    ),
    Rule(
        "RW321",
        "unsupported launch entity",
        _E,
        "What it starts is missing. Pass the sources of its library as a PATH, or name what it starts with --node. Otherwise, please report it.",
    ),
    Rule("RW322", "undeclared launch argument", _W, "Check the spelling. It has no effect."),
    Rule("RW323", "not started by any launch file", _N, "No launch file of the workspace starts this executable."),
    Rule("RW324", "unreadable interface declaration", _E, "Fix the file. See the reference of node declarations."),
    Rule(
        "RW325",
        "environment variable without a value",
        _W,
        'Set it: --env NAME=VALUE, or NAME = "VALUE" in the table [env] of rosward.toml. Until then, every possible value is analysed.',
    ),
    # Loose ends
    Rule(
        "RW331",
        "topic without a publisher",
        _N,
        "Check the name and its remapping. The publisher may not be part of the analysis.",
    ),
    Rule(
        "RW332",
        "topic without a subscription",
        _N,
        "Check the name and its remapping. Perhaps only tools read it, or nothing does.",
    ),
    Rule(
        "RW333",
        "service without a server",
        _N,
        "Check the name and its remapping. The server may not be part of the analysis.",
    ),
    Rule(
        "RW334",
        "action without a server",
        _N,
        "Check the name and its remapping. The server may not be part of the analysis.",
    ),
    # Rights that are put together
    Rule(
        "RW340",
        "permissions widened to fit",
        _N,
        "With --compact, a pattern replaces several names. Check that what it grants in addition is harmless, or split the enclave.",
    ),
    Rule(
        "RW341",
        "enclave assignment without a match",
        _W,
        "Fix the file passed with --enclaves. No node or process has this name.",
    ),
    # Policies that are checked
    Rule("RW401", "missing permission", _E, "Add the rule. Without it, the node fails when it creates this entity."),
    Rule("RW402", "unused permission", _W, "Remove the rule, or name only what is used."),
    Rule("RW403", "unreadable policy", _E, "Fix the file. What could not be read was not compared."),
    Rule("RW404", "enclave without a process", _W, "Remove the enclave, or add what runs in it to the analysis."),
    Rule(
        "RW405",
        "process without an enclave in the policy",
        _E,
        "Add the enclave. Without it, the process does not start.",
    ),
    *LATER,
)

INTERNAL_ERROR: Final = "RW299"
TIME_LIMIT: Final = "s of analysis"
KILLED: Final = "the process that analyses it was killed"
"""What messages of RW201 say that another machine might not find."""
"""The code of a fault of rosward itself."""

UNREAD_ARGUMENT: Final = "RW322"
"""The code of a launch argument that changes nothing."""

MADE_ANEW: Final = "part generated at each start"
"""The cause of what nobody can make known, since no two runs have it in common."""

RULES: Final[dict[str, Rule]] = {rule.code: rule for rule in _TABLE}
