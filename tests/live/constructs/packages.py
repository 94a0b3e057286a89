# SPDX-License-Identifier: Apache-2.0
"""What does an import bind, and what has run by then? Several files: relative imports, namespace packages, any order, cycles.

main.py: from robot1.helpers import get1      robot1/helpers.py: from .topics import NAME       robot1/topics.py: NAME = "left"
"""

from __future__ import annotations

import textwrap
from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create
from ..values import WORDS, word

_ROS: Final = """from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci
"""


def _file(draft: Draft, name: str, text: str) -> None:
    draft.files.setdefault(name, []).append(textwrap.dedent(text).strip("\n"))


def _literal(draft: Draft) -> str:
    return repr(draft.chooser.pick(WORDS))


def relative(draft: Draft, _scope: Scope, _depth: int) -> str:
    """A package whose files import each other by their place, with `__init__.py` or without."""
    pack, value = draft.fresh("robot"), _literal(draft)
    spaced = draft.chooser.chance(40)
    _file(draft, f"{pack}/topics.py", f"NAME = {value}\nOTHER = NAME + '_o'\n__all__ = ['NAME']")
    ways = [
        "from .topics import NAME\n\n\ndef get():\n    return NAME + '_r'",
        "from . import topics\n\n\ndef get():\n    return topics.OTHER",
        "from .topics import *\n\n\ndef get():\n    return NAME + str('OTHER' in globals())",
        "def get():\n    from .topics import OTHER as other\n    return other + '_f'",
        "from .deep.more import far as get",
        "try:\n    from .absent import get\nexcept ImportError:\n    from . import topics\n\n    def get():\n        return topics.NAME + '_tried'",
        "import importlib\n\n\ndef get():\n    return importlib.import_module('.topics', __package__).NAME",
        "def get():\n    return __name__.replace('.', '_') + __package__",
    ]
    _file(draft, f"{pack}/helpers.py", draft.chooser.pick(ways))
    _file(
        draft,
        f"{pack}/deep/more.py",
        "from ..topics import NAME\nfrom .. import topics\n\n\ndef far():\n    return NAME + topics.OTHER",
    )
    if not spaced:
        _file(
            draft,
            f"{pack}/__init__.py",
            draft.chooser.pick(["", "from .helpers import get", "from . import topics", "START = 'init'"]),
        )
        if draft.chooser.chance(50):
            _file(draft, f"{pack}/deep/__init__.py", "")
    draft.define(f"import {pack}.helpers\nimport {pack}.topics as {pack}_topics")
    return draft.chooser.pick([f"{pack}.helpers.get()", f"{pack}_topics.OTHER", f"({pack}.topics.NAME + '_p')"])


def shadowed(draft: Draft, _scope: Scope, _depth: int) -> str:
    """A name of a package that is a file of it, too."""
    pack, value = draft.fresh("shade"), _literal(draft)
    _file(draft, f"{pack}/label.py", f"label = {value}\n\n\ndef made():\n    return label + '_made'")
    init = draft.chooser.pick(
        [
            "from .label import label",
            "label = 'own'\nfrom . import label as _",
            "from .label import made\nlabel = made()",
            "label = 'before'",
            "from . import label",
        ]
    )
    _file(draft, f"{pack}/__init__.py", init)
    draft.define(f"import {pack}\nfrom {pack} import label as {pack}_label")
    if draft.chooser.chance(50):
        draft.define(f"import {pack}.label")
    return f"({pack}_label if isinstance({pack}_label, str) else {pack}_label.label)"


def registry(draft: Draft, _scope: Scope, _depth: int) -> str:
    """Files that enter themselves into a list, in the order in which they are imported."""
    base = draft.fresh("registry")
    _file(draft, f"{base}.py", "items = ['r']\n\n\ndef enter(name):\n    items.append(name + str(len(items)))")
    for each in ("one", "two", "six"):
        first = "" if each != "two" or draft.chooser.chance(50) else f"import {base}_six\n"
        _file(draft, f"{base}_{each}.py", f"{first}from {base} import enter\n\nenter({each!r})")
    order = ["one", "two", "six"]
    for _ in range(3):
        order.append(order.pop(draft.chooser.number(0, 2)))
    draft.define("\n".join([f"import {base}", *(f"import {base}_{each}" for each in order)]))
    return draft.chooser.pick([f"'_'.join({base}.items)", f"{base}.items[1]", f"{base}.items[-1]"])


def circular(draft: Draft, _scope: Scope, _depth: int) -> str:
    """Two files that import each other."""
    one, value = draft.fresh("circle"), _literal(draft)
    _file(
        draft,
        f"{one}.py",
        draft.chooser.pick(
            [
                f"NAME = {value}\nimport {one}_back\nLATE = {one}_back.NAME + '_late'",
                f"import {one}_back\nNAME = {value}\nLATE = {one}_back.get()",
                f"NAME = {value}\nfrom {one}_back import get\nLATE = get() + '_late'",
            ]
        ),
    )
    _file(
        draft,
        f"{one}_back.py",
        f"import {one}\nNAME = getattr({one}, 'NAME', 'early')\n\n\ndef get():\n    return getattr({one}, 'NAME', 'none') + '_g'",
    )
    first = draft.chooser.pick([[one], [f"{one}_back", one], [one, f"{one}_back"]])
    draft.define("\n".join(f"import {each}" for each in first))
    return draft.chooser.pick([f"{one}.LATE", f"__import__('sys').modules['{one}_back'].NAME", f"{one}.NAME"])


def changed(draft: Draft, scope: Scope, depth: int) -> str:
    """A variable of a file that another one sets, before or after a third has read it."""
    base = draft.fresh("settings")
    _file(draft, f"{base}.py", f"NAME = {_literal(draft)}\n\n\ndef get():\n    return NAME + '_now'")
    _file(
        draft,
        f"{base}_user.py",
        f"from {base} import NAME\nimport {base}\n\n\ndef kept():\n    return NAME + '_kept'\n\n\ndef now():\n    return {base}.NAME + '_asked'",
    )
    value = word(draft, scope, depth) if not scope.node else _literal(draft)
    lines = [f"import {base}", f"{base}.NAME = {value}", f"import {base}_user"]
    if draft.chooser.chance(50):
        lines = [f"import {base}_user", *lines[:2]]
    draft.module += scope.lines if not scope.node else []
    if not scope.node:
        scope.lines.clear()
    draft.define("\n".join(lines))
    return draft.chooser.pick([f"{base}.get()", f"{base}_user.kept()", f"{base}_user.now()"])


def dynamic(draft: Draft, scope: Scope, depth: int) -> str:
    """Attributes of a file that a function makes, files that are named by a text, imports that are late."""
    base, value = draft.fresh("dyn"), _literal(draft)
    draft.need("import importlib")
    _file(
        draft,
        f"{base}.py",
        f"NAME = {value}\n\n\ndef __getattr__(name):\n    if name.startswith('_'):\n        raise AttributeError(name)\n    return name + '_made'",
    )
    scope.add(f"import {base} as {base}_late")
    return draft.chooser.pick(
        [
            f"{base}_late.anything",
            f"{base}_late.NAME",
            f"importlib.import_module({base!r}).NAME",
            f"getattr(importlib.import_module('dy' + {base[2:]!r}), 'NAME')",
            f"vars({base}_late)['NAME']",
            f"{base}_late.__name__",
            f"({base}_late.other + {word(draft, scope, depth)})",
        ]
    )


# Entities


def made_elsewhere(draft: Draft, scope: Scope, depth: int) -> None:
    """A function or class in another file that creates entities."""
    pack, there = (
        draft.fresh("parts"),
        Draft(draft.chooser, draft.known, ways=draft.ways, statements=draft.statements, further=draft.further),
    )
    there.numbers = draft.numbers
    inside = Scope([], "node", ["name"])
    create(there, inside, min(depth - 1, 1))
    body = f"def add(node, name):\n{block(inside.lines)}"
    _file(
        draft,
        f"{pack}/adding.py",
        _ROS + "\n".join(sorted(there.imports)) + "\n\n" + "\n\n".join([*there.module, body]),
    )
    for name, lines in there.files.items():
        draft.files.setdefault(name, []).extend(lines)
    draft.used |= there.used
    if draft.chooser.chance(50):
        _file(draft, f"{pack}/__init__.py", draft.chooser.pick(["", "from .adding import add", "from . import adding"]))
    how = draft.chooser.pick(
        [
            f"from {pack}.adding import add as {pack}_add",
            f"import {pack}.adding\n{pack}_add = {pack}.adding.add",
            f"from {pack} import adding as {pack}_adding\n{pack}_add = {pack}_adding.add",
        ]
    )
    if draft.chooser.chance(50):
        draft.define(how)
    else:
        scope.add(how)
    scope.add(f"{pack}_add({scope.node}, {word(draft, scope, 0)})")


WAYS: Final[tuple[Way, ...]] = (relative, relative, shadowed, registry, circular, changed, dynamic)
STATEMENTS: Final[tuple[Statement, ...]] = (made_elsewhere,)
