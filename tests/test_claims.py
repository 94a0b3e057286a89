# SPDX-License-Identifier: Apache-2.0
"""Promise: exit status 0 says that nothing is missing: each finding that says that something may be missing is an error."""

from __future__ import annotations

import enum
from pathlib import Path
from typing import Final

import pytest
from casefile import Case, run_case

import rosward
from rosward.rules import RULES, Severity


class Claim(enum.Enum):
    """What a finding says of the result."""

    MISSING = "something of the system may be missing from the result"
    FAILS = "the real program, or its policy, will not do what it seems to; nothing is missing"
    MORE = "the result may hold more than the system does, or says less of it than could be"
    KNOWN = "something worth knowing, by which nothing is missing"


M, F, L, K = Claim.MISSING, Claim.FAILS, Claim.MORE, Claim.KNOWN
E, W, N = Severity.ERROR, Severity.WARNING, Severity.NOTE

CLAIMS: Final = {
    **dict.fromkeys(("RW001", "RW002", "RW003", "RW005", "RW006", "RW008", "RW012", "RW016", "RW018", "RW019"), (M, E)),
    **dict.fromkeys(("RW004", "RW007", "RW014", "RW015", "RW020"), (L, W)),
    "RW017": (F, W),  # the folder is read whatever its package.xml says
    "RW009": (F, W),  # the package is there and the module is not: the executable does not start
    **dict.fromkeys(("RW010", "RW011", "RW013"), (K, N)),  # what is excluded somebody asked for
    **dict.fromkeys(("RW101", "RW105", "RW106"), (M, E)),
    **dict.fromkeys(("RW102", "RW104"), (L, W)),
    "RW103": (F, E),
    "RW107": (L, N),  # nobody can say more
    "RW108": (L, W),  # defaults hold: with them it is not there
    **dict.fromkeys(
        ("RW201", "RW202", "RW203", "RW204", "RW206", "RW207", "RW208", "RW210", "RW212", "RW214", "RW299"), (M, E)
    ),
    "RW205": (K, N),  # surely not run
    **dict.fromkeys(("RW209", "RW213"), (F, W)),
    "RW211": (K, N),
    **dict.fromkeys(("RW301", "RW303", "RW304", "RW306", "RW308", "RW309"), (F, W)),
    "RW302": (L, W),
    "RW305": (M, E),  # the policy lacks it
    "RW307": (K, N),
    **dict.fromkeys(("RW310", "RW311", "RW312", "RW314", "RW315", "RW319", "RW321", "RW324"), (M, E)),
    **dict.fromkeys(("RW313", "RW318"), (L, W)),
    "RW316": (L, N),
    "RW317": (F, E),
    **dict.fromkeys(("RW320", "RW322"), (F, W)),
    "RW323": (K, N),
    "RW325": (L, W),
    **dict.fromkeys(("RW331", "RW332", "RW333", "RW334"), (K, N)),
    "RW340": (L, N),
    "RW341": (F, W),
    **dict.fromkeys(("RW401", "RW405"), (F, E)),
    **dict.fromkeys(("RW402", "RW404"), (L, W)),
    **dict.fromkeys(("RW403", "RW505"), (M, E)),
    **dict.fromkeys(("RW501", "RW502"), (M, E)),
    **dict.fromkeys(("RW503", "RW504", "RW506"), (L, W)),
    "RW601": (F, E),
    **dict.fromkeys(("RW602", "RW603", "RW605", "RW607"), (F, W)),
    "RW604": (L, W),
    "RW606": (K, N),
}
"""Each code, what it says of the result, and how much it weighs."""


def test_every_code_has_a_claim() -> None:
    """A new code says whether something may be missing."""
    assert CLAIMS.keys() == RULES.keys()


@pytest.mark.parametrize("code", sorted(RULES))
def test_severity_follows_the_claim(code: str) -> None:
    """What may be missing is an error."""
    claim, severity = CLAIMS[code]
    assert RULES[code].severity is severity
    assert severity is E or claim is not Claim.MISSING


HEAD: Final = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
MAIN: Final = "\nrclpy.init()\nrclpy.spin(N())\n"

PROGRAMS: Final = {
    "a library gets the node": (
        "import chip\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n        chip.Driver(self)\n",
        "RW202",
    ),
    "windows get the node": (
        "from PyQt5.QtCore import QTimer\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n        QTimer(self)\n",
        "",
    ),
    "code of a file is run": ("class N(Node):\n    def __init__(self):\n        super().__init__('n')\n        exec(open('x').read())\n", "RW203"),
    "a method by a name that is not known": (
        "class N(Node):\n    def __init__(self):\n        super().__init__('n')\n        getattr(self, input())()\n"
        "    def later(self):\n        self.create_publisher(String, 'x', 10)\n",
        "RW212",
    ),
    "a method of something unknown": (
        "import chip\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n        chip.nodes()[0].later()\n"
        "    def later(self):\n        self.create_publisher(String, 'x', 10)\n",
        "RW212",
    ),
    "a method that nothing calls": (
        "class N(Node):\n    def __init__(self):\n        super().__init__('n')\n"
        "    def later(self):\n        self.create_publisher(String, 'x', 10)\n",
        "",
    ),
    "another program is started": (
        "import subprocess\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n"
        "        subprocess.Popen(['ros2', 'run', 'demo', 'talker'])\n",
        "RW210",
    ),
    "a tool asks": (
        "import subprocess\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n"
        "        subprocess.run(['ros2', 'topic', 'list'])\n",
        "",
    ),
    "a recording is ended": (
        "import os\nclass N(Node):\n    def __init__(self):\n        super().__init__('n')\n"
        "        os.system(\"pgrep -f 'ros2 bag' | xargs kill\")\n",
        "",
    ),
}  # fmt: skip
"""Programs in which something is not followed, and the error that says so ('' where nothing can be missing)."""


@pytest.mark.parametrize("what", PROGRAMS)
def test_what_is_left_out(what: str, tmp_path: Path) -> None:
    """A program is incomplete exactly where what is not followed may create something."""
    source, code = PROGRAMS[what]
    run_case(Case(Path(), what, {"main.py": HEAD + source + MAIN}, [], {}), tmp_path)
    errors = {f.code for f in rosward.extract(tmp_path).findings if f.rule.severity is E}
    assert errors == ({code} if code else set())
