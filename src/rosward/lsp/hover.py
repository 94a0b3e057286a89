# SPDX-License-Identifier: Apache-2.0
"""What is shown of what stands at a position? Names in each launched system, types, QoS, and who is at the other end: Markdown, and short."""

from __future__ import annotations

from typing import Final

from rosward.lsp.marks import Mark, Marks, meeting, plural
from rosward.lsp.records import SOURCES, End, Seen, Setting, Started
from rosward.lsp.state import Found

__all__ = ["code", "hover", "shown_name"]

_MOST: Final = 12
_MOST_OTHERS: Final = 8


def hover(found: list[Found]) -> str:
    """Markdown; empty where there is nothing to say."""
    launched = [f for f in found if f.marks.view.kind != SOURCES] or found
    parts: dict[str, list[str]] = {}
    for each in launched:
        text = _told(each.marks, each.mark)
        if text:
            systems = parts.setdefault(text, [])
            name = shown_name(each.marks)
            if name not in systems:
                systems.append(name)
    shown = [f"{text}\n\n*in {_listed(systems)}*" for text, systems in list(parts.items())[:_MOST]]
    if len(parts) > _MOST:
        shown.append(f"… and {len(parts) - _MOST} more")
    return "\n\n---\n\n".join(shown)


def shown_name(marks: Marks) -> str:
    """What a view is called."""
    return code(marks.view.name) if marks.view.kind != SOURCES else "the sources (`ros2 run`)"


def _listed(systems: list[str]) -> str:
    return ", ".join(systems[:4]) + (f" and {len(systems) - 4} more" if len(systems) > 4 else "")


def _told(marks: Marks, mark: Mark) -> str:
    if isinstance(mark.what, End) and mark.node is not None:
        return _of_end(marks, mark.node, mark.what)
    if isinstance(mark.what, Setting) and mark.node is not None:
        return _of_setting(mark.node, mark.what)
    if isinstance(mark.what, Started):
        return _of_started(marks, mark.what)
    return _of_node(mark.what) if isinstance(mark.what, Seen) else ""


def _of_end(marks: Marks, node: Seen, end: End) -> str:
    lines = [f"**{end.kind}** {code(end.name)} · {code(end.type) if end.type else 'type not known'}"]
    if end.qos:
        lines.append("QoS " + ", ".join(f"depth {v}" if k == "depth" else v for k, v in end.qos))
    lines.append(f"node {code(node.name)}" + (", only in some runs" if end.conditional or node.conditional else ""))
    if end.reasons:
        lines.append("not wholly known: " + "; ".join(_plain(reason) for reason in end.reasons[:3]))
    others = marks.others(end)
    shown = [f"- {_kind(each)} of {code(_node(each))}{_where(each)}" for each in others[:_MOST_OTHERS]]
    if len(others) > _MOST_OTHERS:
        shown.append(f"- … and {len(others) - _MOST_OTHERS} more")
    if not others:
        shown = [f"- nobody at the other end of this {meeting(end)}"]
    return "  \n".join(lines) + "\n\n" + "\n".join(shown)


def _kind(mark: Mark) -> str:
    return mark.what.kind if isinstance(mark.what, End) else ""


def _node(mark: Mark) -> str:
    return "" if mark.node is None else mark.node.name


def _where(mark: Mark) -> str:
    return f" ({_plain(str(mark.place))})"


def _of_setting(node: Seen, setting: Setting) -> str:
    default = f", default {code(setting.default)}" if setting.default else ""
    value = f" is {code(setting.value)}" if setting.value else " has no known value"
    return (
        f"**parameter** {code(setting.name)} of {code(node.name)}{value}  \n{setting.type or 'type not known'}{default}"
    )


def _of_started(marks: Marks, started: Started) -> str:
    lines = [f"**starts** {code(started.label)}" + (f" ({_plain(started.program)})" if started.program else "")]
    for node in marks.nodes_at(started.place)[:_MOST]:
        kinds: dict[str, int] = {}
        for end in node.ends:
            kinds[end.kind] = kinds.get(end.kind, 0) + 1
        counts = ", ".join(plural(number, kind) for kind, number in kinds.items())
        lines.append(f"- node {code(node.name)}" + (f": {counts}" if counts else ""))
    lines += [f"- {code(old)} is remapped to {code(new)}" for old, new in started.remaps[:_MOST]]
    return "\n".join((lines[0], "", *lines[1:]))


def _of_node(node: Seen) -> str:
    started = f"  \nstarted by {_plain(str(node.launched_by))}" if node.launched_by is not None else ""
    program = f" · {code(f'{node.package}/{node.executable}')}" if node.package and node.executable else ""
    assumed = "  \nassumed: nothing in the sources makes it" if node.assumed else ""
    return f"**node** {code(node.name)}{program}{started}{assumed}"


def code(text: str) -> str:
    """A text as code, whatever it holds."""
    plain = "".join(c if c.isprintable() else "�" for c in text).replace("`", "'")
    return f"`{plain}`"


def _plain(text: str) -> str:
    """A text in which nothing means anything to Markdown."""
    return "".join(f"\\{c}" if c in "\\`*_{}[]()#+!|<>~" else c if c.isprintable() else " " for c in text)
