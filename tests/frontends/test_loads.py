# SPDX-License-Identifier: Apache-2.0
"""Promise: which modules a file may load by name is known by its text, and that takes little, whatever stands there."""

from __future__ import annotations

import ast

import pytest

from rosward.frontends.python.loads import loads


def found(text: str) -> list[str]:
    text = f"import importlib, pkgutil\n{text}\n"
    return loads(ast.parse(text), text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("importlib.import_module('plugs.nav')", ["plugs.nav"]),
        ("importlib.import_module(f'plugs.{kind}')", ["plugs.*"]),
        ("importlib.import_module('plugs.%s_node' % kind)", ["plugs.*_node"]),
        ("importlib.import_module('plugs.{}'.format(kind))", ["plugs.*"]),
        ("importlib.import_module(f'.{kind}', __package__)", [".*"]),
        ("name = 'a' if fast else 'b'\nimportlib.import_module(name)", ["a", "b"]),
        ("_T = {'a': 'plugs.a', 'b': 'plugs.b'}\nimportlib.import_module(_T[key])", ["plugs.a", "plugs.b"]),
        ("def load(name): importlib.import_module(name)", ["*"]),
        ("import plugs\npkgutil.iter_modules(plugs.__path__)", []),
        ("importlib.import_module(name)\n" * 300 + "importlib.import_module('last')", ["*", "last"]),
        ("import json", []),
        ("pkgutil.iter_modules(__path__)", []),
        ("for m in pkgutil.iter_modules(__path__): importlib.import_module(m.name)", [".*", "*"]),
        ("__all__ = ['nav', 'run', 'pkgutil', 'Base']\nclass Base: ...\ndef run(): ...", [".nav"]),
        ("__all__ = [*a.__all__, *(b.__all__ + ['nav'])]", [".nav"]),
        ("__all__ = []\nfor name in names: __all__.append(name)", [".*"]),
        ("__all__ = ['nav']\n__all__ += [n for n in names]", [".*"]),
    ],
)
def test_names(text: str, expected: list[str]) -> None:
    assert found(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "a0 = 'x'\n" + "".join(f"a{i + 1} = f'{{a{i}}}{{a{i}}}'\n" for i in range(60)) + "importlib.import_module(a60)",
        "importlib.import_module(" + " + 'x' + ".join(["a"] * 200) + ")",
        "".join(f"importlib.import_module(f'x{i}{{y}}')\n" for i in range(2_000)),
        "".join(f"a = 'x{i}'\n" for i in range(2_000)) + "importlib.import_module(a)\n" * 2_000,
        "_T = {"
        + "".join(f"'{i}': 'x{i}', " for i in range(2_000))
        + "}\n"
        + "importlib.import_module(_T[k])\n" * 2_000,
    ],
    ids=["doubled", "holes", "names", "values", "table"],
)
def test_what_would_be_too_much_is_short(text: str) -> None:
    assert all(len(name) < 400 and name.count("*") <= 2 for name in found(text))
    assert len(found(text)) <= 100
