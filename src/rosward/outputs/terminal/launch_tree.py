# SPDX-License-Identifier: Apache-2.0
"""What launch files start, as a tree for people and as JSON.

bringup/launch/robot.launch.py
└─ includes sim.launch.py  (robot.launch.py:12)
   └─ node demo/talker  (sim.launch.py:5)
        name       talker_left        argument side (default)
        parameter  rate = 10.0        $(find-pkg-share bringup)/config/talker.yaml
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rosward.findings import Finding
from rosward.network.launch_tree import Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.safe import printable


def launch_tree_text(systems: Iterable[LaunchSystem], findings: Sequence[Finding]) -> str:
    """The tree of each system, then what is not known."""
    lines: list[str] = []
    for system in systems:
        lines += [system.file or system.name, *_branch(system.entries, 0, ""), ""]
    if findings:
        lines += [f"{f.rule.severity.value} {f.code} {f.place}  {f.message}" for f in findings]
        lines.append("")
    return "\n".join(printable(line) for line in lines)


def _branch(entries: Sequence[LaunchEntry], depth: int, indent: str) -> list[str]:
    """The entries below the includes that they share; includes stand where their first entry does."""
    groups: list[tuple[Inclusion | None, list[LaunchEntry]]] = []
    for each in entries:
        step = each.trail[depth] if len(each.trail) > depth else None
        if step is not None and groups and groups[-1][0] == step:
            groups[-1][1].append(each)
        else:
            groups.append((step, [each]))
    lines: list[str] = []
    for number, (step, members) in enumerate(groups):
        last = number == len(groups) - 1
        mark, below = ("└─ ", "   ") if last else ("├─ ", "│  ")
        if step is None:
            lines += _entry(members[0], indent + mark, indent + below)
        else:
            lines.append(f"{indent}{mark}include {step.file}  ({step.place})")
            lines += _branch(members, depth + 1, indent + below)
    return lines


def _entry(each: LaunchEntry, first: str, rest: str) -> list[str]:
    conditions = [f"if {'; '.join(each.why) or 'an unknown condition'}"] if each.conditional else []
    conditions += [f"after {each.event}"] if each.event else []
    said = f"  [{', '.join(conditions)}]" if conditions else ""
    rows: list[tuple[str, str, str]] = []
    for word, value in (("name", each.name), ("namespace", each.namespace), ("container", each.container)):
        if value is not None:
            rows.append((word, value.text, value.source))
    rows += [("remap", f"{a.text} → {b.text}", "; ".join(s for s in (a.source, b.source) if s)) for a, b in each.remaps]
    for parameter in each.parameters:
        text = parameter.value.text if parameter.kind == "file" else f"{parameter.name} = {parameter.value.text}"
        rows.append(("params" if parameter.kind == "file" else "param", text, parameter.value.source))
    rows += [("env", f"{name}={value.text}", value.source) for name, value in each.environment]
    if each.program:
        rows.append(("program", each.program, ""))
    place = f"  ({each.place})" if each.place.file else ""  # none where the user named the executable
    lines = [f"{first}{each.kind} {_title(each)}{place}{said}"]
    wide = max((min(len(text), 44) for _, text, source in rows if source), default=0)
    for word, text, source in rows:
        lines.append(
            f"{rest}    {word:<9} {text:<{wide}}  {source}".rstrip() if source else f"{rest}    {word:<9} {text}"
        )
    return lines


def _title(each: LaunchEntry) -> str:
    if each.kind == "process":
        return " ".join(w.text for w in each.words) or _text(each.executable)
    inner = each.plugin if each.plugin is not None else each.executable
    return f"{_text(each.package)}/{_text(inner)}" if each.package is not None else _text(inner)


def _text(value: Shown | None) -> str:
    return value.text if value is not None else "?"
