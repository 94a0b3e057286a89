# SPDX-License-Identifier: Apache-2.0
"""The table of rules, and the record of one finding.

A finding is the only way in which rosward speaks of a doubt: what is not known, not read or assumed has a code,
a place, a message and what to do about it. Codes are stable: RW0xx input, RW1xx names, RW2xx analysis, RW3xx system and policy,
RW4xx policies that are checked, RW5xx running systems.
"""

from __future__ import annotations

import enum
from collections.abc import Iterable, Iterator
from typing import Final, NamedTuple, final

from rosward.source.location import Place


class Severity(enum.Enum):
    """How much a finding weighs; an `error` makes the result incomplete."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"

    @property
    def rank(self) -> int:
        """0 for the heaviest."""
        return list(Severity).index(self)


class Rule(NamedTuple):
    """One kind of finding: its stable code, a short title, its severity and what a user can do about it."""

    code: str
    title: str
    severity: Severity
    help: str


_E, _W, _N = Severity.ERROR, Severity.WARNING, Severity.NOTE

_TABLE: Final = (
    # Input
    Rule("RW001", "syntax error", _E, "Correct the file, or exclude it: nothing in it is in the result."),
    Rule("RW002", "file cannot be read", _E, "Check permissions and links: nothing in it is in the result."),
    Rule("RW003", "file too large", _E, "Exclude generated data, or split the file: it was not analysed."),
    Rule("RW004", "text encoding", _W, "Declare the encoding (PEP 263) or save the file as UTF-8."),
    Rule("RW005", "nesting too deep", _E, "Simplify the expression: the file was not analysed."),
    Rule("RW006", "Python 2 source", _E, "Port the file to Python 3, or exclude it: nothing in it is in the result."),
    Rule("RW007", "no ROS 2 code found", _N, "Name a workspace, a package or a file that uses rclpy."),
    Rule(
        "RW008",
        "package description cannot be read",
        _E,
        "Correct the setup.py, setup.cfg, pyproject.toml or CMakeLists.txt: executables and modules that it names may be missing.",
    ),
    Rule(
        "RW009",
        "executable without source",
        _W,
        "The entry point names a module or function that is not among the sources.",
    ),
    Rule(
        "RW010",
        "ignore comment without a finding",
        _N,
        "Remove the comment, or the code from its brackets: it ignores nothing.",
    ),
    Rule(
        "RW011",
        "excluded by a pattern",
        _N,
        "Nothing of it was read: what it creates is not in the result. See --exclude.",
    ),
    Rule(
        "RW012",
        "link out of the sources",
        _E,
        "Name the folder that it leads to as a PATH, or follow links (--follow-links): nothing behind it is in the result.",
    ),
    Rule(
        "RW013",
        "folder marked to be ignored",
        _N,
        "colcon does not build what is in it, and it is not in the result. Name the folder as a PATH to analyse it.",
    ),
    Rule(
        "RW014",
        "package name used twice",
        _W,
        "colcon refuses two packages of one name, and the result holds both: exclude one of them (--exclude).",
    ),
    Rule(
        "RW015",
        "launch file in an ignored folder",
        _W,
        "colcon does not install what is beside it. Name its folder as a PATH, too, so that its programs are found.",
    ),
    Rule(
        "RW016",
        "executable from elsewhere",
        _E,
        "Add the package of the module to the analysis: what it creates is missing.",
    ),
    Rule(
        "RW017",
        "faulty package.xml",
        _W,
        "Correct it: the ROS tools refuse the package. Its folder was read all the same.",
    ),
    # Names and types
    Rule("RW101", "unknown name", _E, "Give the value that is missing a default in the source."),
    Rule("RW102", "partly known name", _W, "Supply the missing part, or accept the wildcard in the policy."),
    Rule("RW103", "invalid name", _E, "rcl rejects this name: the call fails when it runs."),
    Rule("RW104", "unknown type", _W, "Import the interface type directly, so that it can be named."),
    Rule(
        "RW105",
        "unknown node name",
        _E,
        "Give the node a name in the source, or a default to what it is made of.",
    ),
    Rule(
        "RW106",
        "unknown ROS arguments",
        _E,
        "Write the arguments in the source: remap rules among them rename nodes, topics and services.",
    ),
    Rule(
        "RW107",
        "name made at each start",
        _N,
        "Nobody can know it before: the policy has a pattern for it, which allows the same below every such name.",
    ),
    # Analysis
    Rule(
        "RW201",
        "limit reached",
        _E,
        "The analysis stopped early here: the result lacks what comes after. `--budget 4` gives it four times the steps.",
    ),
    Rule(
        "RW202",
        "node handed to an unknown library",
        _E,
        "Describe the library in a stub file (--models), or check by hand what it creates.",
    ),
    Rule("RW203", "code made at run time", _E, "exec, eval, dynamic imports and the like are not followed."),
    Rule(
        "RW204",
        "base class not among the sources",
        _E,
        "Add its package to the analysis, or describe it in a stub file (--models).",
    ),
    Rule(
        "RW205", "entity in code that never runs", _N, "No entry point reaches this call: it is left out of the result."
    ),
    Rule("RW206", "construct not understood", _E, "Please report it; what it would create is missing."),
    Rule(
        "RW207",
        "module not among the sources",
        _E,
        "Add its package to the analysis, or install it beside the workspace.",
    ),
    Rule(
        "RW208", "entity on an unknown node", _E, "The node that this call belongs to is not known: it is in no policy."
    ),
    Rule("RW209", "call fails when it runs", _W, "The real library raises an exception here."),
    Rule(
        "RW210",
        "starts another program",
        _E,
        "The program started here is not part of the result; analyse or declare it.",
    ),
    Rule("RW211", "starts a tool of ROS", _N, "Tools of the command line are no part of the system."),
    Rule(
        "RW212",
        "entity in code that may run",
        _E,
        "Something unknown may call it: make known what it is called on, or what it is called by.",
    ),
    Rule(
        "RW213",
        "message of the wrong type",
        _W,
        "The client library raises TypeError here: send the type that the entity was created with.",
    ),
    Rule(
        "RW299",
        "internal error",
        _E,
        "A fault of rosward, not of this file: please report it, with the file if you can. What the message names is not in the result.",
    ),
    # System and policy
    Rule(
        "RW301",
        "several nodes in one process",
        _W,
        "They share one context, so one enclave: start them with an enclave whose policy has both profiles.",
    ),
    Rule(
        "RW302",
        "wildcard grants more than one name segment",
        _W,
        "In DDS permissions * also matches /: make the unknown part known.",
    ),
    Rule(
        "RW303",
        "enclave path too long",
        _W,
        "A certificate cannot hold a path of more than 64 characters: choose a shorter one when you start the process.",
    ),
    Rule(
        "RW304",
        "permissions too large",
        _W,
        "The DDS handshake fails above about 64 KB: split the enclave (`rosward enclaves suggest`), or let patterns stand for names (`--compact`).",
    ),
    Rule(
        "RW305",
        "topic outside the ROS name space",
        _E,
        "avoid_ros_namespace_conventions has no form in policy.xml: write the DDS permission by hand.",
    ),
    Rule(
        "RW306",
        "differing types on one name",
        _W,
        "Publisher and subscription (server and client) of different type never talk.",
    ),
    Rule("RW307", "node name used twice", _N, "Two nodes of one full name share their policy: rename one of them."),
    Rule(
        "RW308",
        "enclaves conflict",
        _W,
        "One process has one enclave: name it in one place only (--enclave, or ROS_SECURITY_ENCLAVE_OVERRIDE).",
    ),
    Rule(
        "RW309",
        "incompatible QoS",
        _W,
        "The two never talk: let the publisher offer what the subscription requests, or the subscription request less.",
    ),
    # Deployment
    Rule("RW310", "launch file cannot be read", _E, "Correct the launch file: what it starts is not in the result."),
    Rule(
        "RW311",
        "included launch file not found",
        _E,
        "Name the folder of its package (--underlay): what it starts and sets is not in the result.",
    ),
    Rule("RW312", "launch argument without a value", _E, "Give it on the command line: --arg NAME:=VALUE."),
    Rule(
        "RW313",
        "launch value not known",
        _W,
        "Give the launch argument or environment variable that it depends on a value (--arg NAME:=VALUE, --env NAME=VALUE).",
    ),
    Rule(
        "RW314",
        "node of unknown interface",
        _E,
        "Declare what it has: `rosward declare PACKAGE/EXECUTABLE` begins the file, by hand, from a running robot or from its source (--from).",
    ),
    Rule(
        "RW315",
        "parameter file not found",
        _E,
        "launch goes on without it, and so does the analysis: correct the path, or build what makes the file.",
    ),
    Rule(
        "RW316",
        "launch condition not known",
        _N,
        "Both ways are taken; settle it with --arg NAME:=VALUE or --env NAME=VALUE.",
    ),
    Rule("RW317", "parameter file cannot be read", _E, "rcl refuses this file: the node ends when it starts."),
    Rule(
        "RW318",
        "component without its container",
        _W,
        "Nothing starts the container that this component is loaded into: it is analysed as if something did.",
    ),
    Rule("RW319", "program that is no known node", _E, "If it talks over ROS, declare its interface (--models)."),
    Rule(
        "RW320",
        "launch fails here",
        _W,
        "The real launch ends here, or the process when it starts; the result holds also what would follow.",
    ),
    Rule(
        "RW321",
        "launch entity not understood",
        _E,
        "What it would start is missing: name the sources of the library that makes it as a PATH, or start that by --node. Else please report it.",
    ),
    Rule("RW322", "launch argument that nothing declares", _W, "Check the spelling: it changes nothing."),
    Rule("RW323", "no launch file starts it", _N, "The executable is in no launch file of the workspace."),
    Rule("RW324", "declared interface cannot be read", _E, "Correct the file: see the reference of node declarations."),
    Rule(
        "RW325",
        "environment variable that is not given",
        _W,
        'Give it a value: --env NAME=VALUE, or NAME = "VALUE" in the table [env] of rosward.toml. Till then each of its values is followed.',
    ),
    # Loose ends
    Rule("RW331", "topic that nobody publishes", _N, "Check name and remapping; or the publisher is not analysed."),
    Rule(
        "RW332", "topic that nobody subscribes to", _N, "Check name and remapping; or tools alone, or nobody, reads it."
    ),
    Rule("RW333", "service without a server", _N, "Check name and remapping; or the server is not analysed."),
    Rule("RW334", "action without a server", _N, "Check name and remapping; or the server is not analysed."),
    # Rights that are put together
    Rule(
        "RW340",
        "rights widened to fit",
        _N,
        "A pattern stands for several names, as --compact asks: see whether what it allows besides is harmless, or split the enclave.",
    ),
    Rule(
        "RW341",
        "assignment of nothing that runs",
        _W,
        "Correct the file that --enclaves names: no node or process is called so.",
    ),
    # Policies that are checked
    Rule("RW401", "right that is lacking", _E, "Add the rule, or the node fails when it creates this."),
    Rule("RW402", "right that is never used", _W, "Take the rule away, or name only what is used."),
    Rule("RW403", "policy cannot be read", _E, "Correct the file: what is not read was not compared."),
    Rule("RW404", "enclave of no process", _W, "Take the enclave away, or add what runs in it to the analysis."),
    Rule("RW405", "process without an enclave in the policy", _E, "Add the enclave: the process does not start."),
    # Running systems
    Rule(
        "RW501",
        "running node that the source does not explain",
        _E,
        "Find out who starts it; name its source, its launch file or its declaration, or accept it (--allow).",
    ),
    Rule(
        "RW502",
        "running entity that the source does not explain",
        _E,
        "Find out what creates it: another version of the program, a parameter, a plugin; or accept it (--allow).",
    ),
    Rule(
        "RW503",
        "expected, and not running",
        _W,
        "Look at the log of its node; or analyse what really is started (--launch, --arg, --params).",
    ),
    Rule(
        "RW504",
        "running with another type or QoS",
        _W,
        "Build and start the version that was analysed, or analyse the one that runs.",
    ),
    Rule(
        "RW505",
        "part of the running system not known",
        _E,
        "Take the snapshot again, or correct the text: what is not known was not compared.",
    ),
    Rule(
        "RW506",
        "running, explained by an unknown name only",
        _W,
        "Give the value that is missing a default in the source, or accept the name (--allow).",
    ),
)

INTERNAL_ERROR: Final = "RW299"
"""The code of a fault of rosward itself."""

UNREAD_ARGUMENT: Final = "RW322"
"""The code of a launch argument that changes nothing."""

MADE_ANEW: Final = "part that the program makes anew at each start"
"""The cause of what nobody can make known, since no two runs have it in common."""


RULES: Final[dict[str, Rule]] = {rule.code: rule for rule in _TABLE}


class Finding(NamedTuple):
    """One doubt at one place: `code` is a key of `RULES`; `message` says what is the matter and, where known, how to settle it.

    `causes` say by what it is there, so that findings of one cause are told together (`one_cause.py`); none where that is not known.
    `nodes` are the full names of those that it is about, where that is known and its place alone does not say it. `remedy` is what the message
    ends with where it says how to settle it: then that counts, and not the help of the rule.
    """

    code: str
    message: str
    place: Place
    causes: tuple[str, ...] = ()
    nodes: tuple[str, ...] = ()
    remedy: str = ""

    @property
    def rule(self) -> Rule:
        """The rule that this finding is an instance of."""
        return RULES[self.code]


@final
class Findings:
    """Findings, each once, in the order in which they were added."""

    __slots__ = ("_kept",)

    def __init__(self, findings: Iterable[Finding] = ()) -> None:
        self._kept = dict.fromkeys(findings)

    def add(self, finding: Finding) -> None:
        """Add a finding, unless it is there."""
        self._kept[finding] = None

    def update(self, findings: Iterable[Finding]) -> None:
        """Add each of several findings."""
        self._kept.update(dict.fromkeys(findings))

    def __iter__(self) -> Iterator[Finding]:
        return iter(self._kept)

    def __len__(self) -> int:
        return len(self._kept)

    def __contains__(self, finding: object) -> bool:
        return finding in self._kept


def each_once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """The findings sorted by place, those of one code, place and message as one, of all their causes and nodes."""
    found: dict[tuple[Place, str, str], Finding] = {}
    for finding in findings:
        key = (finding.place, finding.code, finding.message)
        known = found.get(key)
        found[key] = finding if known is None else _both(known, finding)
    return tuple(found[key] for key in sorted(found))


def _both(left: Finding, right: Finding) -> Finding:
    """One for two findings that say the same."""
    causes = tuple(sorted({*left.causes, *right.causes}))
    return left._replace(causes=causes, nodes=tuple(sorted({*left.nodes, *right.nodes})))
