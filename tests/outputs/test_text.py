# SPDX-License-Identifier: Apache-2.0
"""The summary on the terminal: short, complete in its numbers, and harmless to the terminal."""

from __future__ import annotations

import io
import subprocess
import sys

from rich.console import Console

from rosward.findings import Finding
from rosward.location import Place
from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.terminal.paper import Drawn, Plain
from rosward.outputs.terminal.summary import summary

from .networks import fleet, talker_and_listener


def printed(network: Network, verbose: bool = False, written: tuple[str, ...] = ()) -> str:
    stream = io.StringIO()
    summary(network, Drawn(Console(file=stream, width=60)), verbose, written)
    plain = io.StringIO()
    summary(network, Plain(plain), verbose, written)
    assert plain.getvalue() == stream.getvalue()
    return stream.getvalue()


def test_the_whole_of_a_small_summary() -> None:
    assert (
        printed(talker_and_listener(), written=("rosward-out/report.html",))
        == """\
rosward read 2 files (120 lines) for jazzy: 2 nodes in 2 processes.

  nodes 2 · topics 5 (2 system) · services 15 (14 system) · actions 1
  names 7: 4 exact, 1 default, 1 pattern, 1 unknown

error RW101 unknown name: 1
  src/demo/demo/node.py:60  publisher of node /robot1/listener: sys.argv[1] is not known (main.py:3)
  Give the missing value a default in the source.

warning RW102 partially known name: 1
  src/demo/demo/node.py:31  publisher /robot_*/cmd_vel: parameter 'robot_id' has no default
  Supply the missing part, or accept the wildcard in the policy.

warning RW302 wildcard matches more than one name segment: 1
  src/demo/demo/node.py:31  node /robot1/talker: publisher /robot_*/cmd_vel: it also allows /robot_any/depth/cmd_vel
  In DDS permissions, * also matches /. Make the unknown part known.

Incomplete: 1 error, 2 warnings.
  rosward-out/report.html
"""
    )


def test_long_lists_are_cut_and_say_so() -> None:
    findings = [Finding("RW202", f"call {n}", Place("a.py", n)) for n in range(1, 8)]
    text = printed(connect("jazzy", [], findings))
    assert "a.py:5  call 5\n  … and 2 more (use -v to list all)\n" in text
    assert "call 6" not in text
    assert "call 7" in printed(connect("jazzy", [], findings), verbose=True)


def test_notes_are_counted_and_shown_if_asked() -> None:
    network = connect("jazzy", [], [Finding("RW205", "dead", Place("a.py", 1))])
    assert "Complete: no errors, 0 warnings, 1 note (use -v to show notes).\n" in printed(network)
    assert "a.py:1  dead" not in printed(network)
    assert "a.py:1  dead" in printed(network, verbose=True)


def test_markup_and_escape_sequences_in_names_are_shown_as_they_are() -> None:
    finding = Finding("RW101", "[red]x[/red] \x1b]0;title\x07 \u202e \ud800", Place("[b]\n.py", 1))
    text = printed(connect("jazzy", [], [finding]))
    assert r"[b]\x0a.py:1  [red]x[/red] \x1b]0;title\x07 \u202e \ud800" in text
    text.encode()


def test_plain_where_there_is_no_terminal() -> None:
    assert "\x1b" not in printed(fleet(1), verbose=True)


def test_outputs_are_light_to_import() -> None:
    """What the command line always needs must not draw in what renders and prints."""
    code = (
        "import sys, rosward.network.connect, rosward.outputs.policies.policy, rosward.outputs.policies.permissions, "
        "rosward.outputs.documents.network_json, rosward.outputs.graphs.dot, rosward.outputs.terminal.summary; "
        "print(sorted({'rich', 'jinja2', 'subprocess'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"
