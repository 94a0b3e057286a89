# SPDX-License-Identifier: Apache-2.0
"""The rules about what runs, and about what flows where: the end of the table."""

from __future__ import annotations

from typing import Final

from rosward.rule import Rule, Severity

_E, _W, _N = Severity.ERROR, Severity.WARNING, Severity.NOTE

LATER: Final = (
    # Running systems
    Rule(
        "RW501",
        "unexplained running node",
        _E,
        "Find out what starts it. Then add its source, launch file or declaration, or accept it (--allow).",
    ),
    Rule(
        "RW502",
        "unexplained running entity",
        _E,
        "Find out what creates it, such as another version of the program, a parameter or a plugin, or accept it (--allow).",
    ),
    Rule(
        "RW503",
        "expected but not running",
        _W,
        "Check the log of its node, or analyse what is actually started (--launch, --arg, --params).",
    ),
    Rule(
        "RW504",
        "running with a different type or QoS",
        _W,
        "Build and start the version that was analysed, or analyse the version that runs.",
    ),
    Rule(
        "RW505",
        "unknown part of the running system",
        _E,
        "Take the snapshot again or fix the text. Unknown parts were not compared.",
    ),
    Rule(
        "RW506",
        "running, explained only by an unknown name",
        _W,
        "Give the missing value a default in the source, or accept the name (--allow).",
    ),
    # Information flow
    Rule(
        "RW601",
        "forbidden flow",
        _E,
        "Break the path at one of its lines, or add a [[flow.release]] that says why it is safe.",
    ),
    Rule(
        "RW602",
        "release without effect",
        _W,
        "Correct the names in `through` and `of`, or remove the [[flow.release]].",
    ),
    Rule(
        "RW603",
        "flow rule names nothing",
        _W,
        "Correct the name, or remove it from the [[flow.rule]]. The rule does not protect it.",
    ),
    Rule(
        "RW604",
        "forbidden flow assumed",
        _W,
        "Add the source of the node, or declare its `flows:`; until then each of its outputs may hold each of its inputs.",
    ),
    Rule(
        "RW605",
        "message content is executed",
        _W,
        "Who may send the message decides what runs. Choose from fixed commands, or check the content first.",
    ),
    Rule(
        "RW606",
        "protected content decides its release",
        _N,
        "Who sees when something is released learns about what is protected. Make the decision depend on something else.",
    ),
    Rule(
        "RW607",
        "contradicting flow rules",
        _W,
        "Change one of the two rules: one allows by name what the other forbids.",
    ),
)
"""Behind the others."""
