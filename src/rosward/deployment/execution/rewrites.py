# SPDX-License-Identifier: Apache-2.0
"""What becomes of the parameters of a file when its text or its values are rewritten (RewrittenYaml, ReplaceString, allow_substs).

/amcl base_frame: base_link    with param_rewrites {'base_frame': 'left/base'}, root_key 'left'    ->    /left/amcl base_frame: left/base

A rewritten value may be unknown or one of several: then the parameter is.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

from rosward.deployment.execution.yaml_values import as_rcl_reads, plain_text
from rosward.domain.choice import join, lift, options
from rosward.domain.compound import Tuple
from rosward.domain.text import matches, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.effects.configuration import Given
from rosward.location import Place

Pairs = Sequence[tuple[Value, Value]]
Rows = tuple[Given, ...]
_KEY: Final = "ros__parameters"


def key_path(node: str) -> str:
    """The key of a node as one path without slashes at its ends: 'left/arm'."""
    return "/".join(part for part in node.split("/") if part)


def converted(value: Value, numbers: bool) -> Value:
    """What RewrittenYaml makes of the text of a new value: a bool, with convert_types a number, else the text."""

    def one(option: Value) -> Value:
        text = plain_text(option)
        if text is None or not isinstance(option, Const):
            return option
        if numbers:
            try:
                return Const(float(text) if "." in text else int(text), option.origins)
            except ValueError:
                pass
        lower = text.lower()
        return Const(lower == "true", option.origins) if lower in ("true", "false") else as_rcl_reads(option)

    return lift(one, value)


def with_values(rows: Rows, rewrites: Pairs, numbers: bool, place: Place) -> Rows:
    """param_rewrites: by the last key, wherever it stands, or by the whole path; a path with ros__parameters that is new is added."""
    found = list(rows)
    for key, text in rewrites:
        value = converted(text, numbers)
        for option in options(key):
            name = plain_text(option)
            sure = option is key
            if name is None:
                found = [r._replace(value=join(r.value, value)) if _may_name(option, r) else r for r in found]
                continue
            path = ".".join(part for part in name.replace("/", ".").split(".") if part)
            hit = False
            for index, row in enumerate(found):
                at = _position(row, name, path)
                if at is not None:
                    hit = True
                    found[index] = row._replace(name=at, value=value if sure else join(row.value, value))
            if not hit and _KEY in path.split("."):
                node, _, rest = path.partition(f"{_KEY}.")
                found.append(Given(node.strip(".").replace(".", "/"), rest, value, place))
    return tuple({(r.node, r.name): r for r in found}.values())


def _position(row: Given, name: str, path: str) -> str | None:
    """The name of the row's parameter after the rewrite of `name`, None where it does not concern it."""
    if path == f"{key_path(row.node).replace('/', '.')}.{_KEY}.{row.name}":
        return row.name
    dotted = f".{row.name}."
    at = dotted.find(f".{name}.")
    return None if at < 0 else row.name[: at + len(name)]


def _may_name(key: Value, row: Given) -> bool:
    return matches(key, row.name) or matches(key, row.name.rpartition(".")[2])


def with_keys(rows: Rows, rewrites: Pairs) -> Rows:
    """key_rewrites: each key of the file, of nodes and of parameters."""
    table = {old: readable(new) for key, new in rewrites if (old := plain_text(key)) is not None}
    if not table:
        return rows
    return tuple(
        row._replace(
            node=table.get(row.node) or "/".join(table.get(part, part) for part in row.node.split("/")),
            name=".".join(table.get(part, part) for part in row.name.split(".")),
        )
        for row in rows
    )


def with_new_values(rows: Rows, rewrites: Pairs, numbers: bool) -> Rows:
    """value_rewrites: each value, or element of a list, whose str() is that text."""
    table = {old: converted(new, numbers) for key, new in rewrites if (old := plain_text(key)) is not None}

    def one(option: Value) -> Value:
        if isinstance(option, Tuple):
            return Tuple(tuple(lift(one, i) for i in option.items))
        return table.get(str(option.value), option) if isinstance(option, Const) else option

    return tuple(row._replace(value=lift(one, row.value)) for row in rows) if table else rows


def below(rows: Rows, root: str) -> Rows:
    """root_key: everything stands under one more key. rcl refuses what then has two slashes in a row (`is_refused_below`)."""
    return tuple(row._replace(node=f"{root.rstrip('/')}/{key_path(row.node)}") for row in rows) if root else rows


def is_refused_below(rows: Rows, root: str) -> bool:
    """Whether rcl refuses the file with this root_key: the name of a node has an empty part."""
    return bool(root) and any(row.node.startswith("/") for row in rows)


def joined_rows(ways: Sequence[Rows], place: Place) -> Rows:
    """One content for several that are possible: values are joined; what is not in all of them may be missing."""
    if len(ways) == 1:
        return ways[0]
    tables = [{(r.node, r.name): r for r in rows} for rows in ways]
    keys = dict.fromkeys(key for table in tables for key in table)
    return tuple(_joined(key, [table.get(key) for table in tables], place) for key in keys)


def _joined(key: tuple[str, str], rows: Iterable[Given | None], place: Place) -> Given:
    result: Given | None = None
    missing = False
    for row in rows:
        if row is None:
            missing = True
        else:
            result = row if result is None else result._replace(value=join(result.value, row.value))
    assert result is not None
    if not missing:
        return result
    return result._replace(value=join(result.value, Unknown((Reason(Cause.PARAMETER, key[1], place),))))
