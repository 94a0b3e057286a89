# SPDX-License-Identifier: Apache-2.0
"""Which options has each command? Written from the parsers, so that the page is what `--help` says.

    parser.add_argument("--node", metavar="PKG/EXE", help="this executable, too")

becomes

    `--node PKG/EXE`
    :   this executable, too
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from typing import Final

__all__ = ["command_reference", "commands_of"]

_COLUMNS: Final = 88


def commands_of(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """The commands below a parser, by their whole name (`enclaves suggest`), in the order of their declaration."""
    found: dict[str, argparse.ArgumentParser] = {}
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for name, inner in action.choices.items():
                below = commands_of(inner)
                found.update({f"{name} {deeper}": each for deeper, each in below.items()} or {name: inner})
    return found


def command_reference(parser: argparse.ArgumentParser) -> str:
    """A section of Markdown for each command."""
    return "\n".join(_section(name, each) for name, each in commands_of(parser).items())


def _section(name: str, parser: argparse.ArgumentParser) -> str:
    formatter = argparse.HelpFormatter(parser.prog, width=_COLUMNS)
    formatter.add_usage(parser.usage, parser._actions, parser._mutually_exclusive_groups, prefix="")
    paragraphs = [f"## rosward {name} {{ #{name.replace(' ', '-')} }}", _prose(parser.description or "")]
    paragraphs.append("```text\n" + formatter.format_help().strip() + "\n```")
    for group in parser._action_groups:
        options = list(_options(parser, group._group_actions))
        if options:
            title = (group.title or "").capitalize().replace("Positional arguments", "Arguments")
            paragraphs += [
                f"**{_prose(title)}**",
                *([_prose(group.description)] if group.description else []),
                *options,
            ]
    paragraphs.append(_prose(parser.epilog or ""))
    return "\n\n".join(p for p in paragraphs if p) + "\n"


def _options(parser: argparse.ArgumentParser, actions: list[argparse.Action]) -> Iterator[str]:
    formatter = parser._get_formatter()
    for action in actions:
        if action.help == argparse.SUPPRESS or isinstance(action, argparse._HelpAction):
            continue
        value = "" if action.nargs == 0 else formatter._format_args(action, _metavar(action))
        names = [f"{option} {value}".strip() for option in action.option_strings] or [value]
        told = formatter._expand_help(action) if action.help else ""
        repeated = isinstance(action, argparse._AppendAction) and "repeated" not in told
        text = _prose(told) + ("; may be repeated" if repeated else "")
        yield ", ".join(f"`{n}`" for n in names) + f"\n:   {text or '&nbsp;'}"


def _metavar(action: argparse.Action) -> str:
    """What stands for the value in `--help`."""
    if action.choices is not None and action.metavar is None:
        return "{" + ",".join(str(choice) for choice in action.choices) + "}"
    return action.dest.upper() if action.option_strings else action.dest


def _prose(text: str) -> str:
    """A text of `--help` as Markdown: what is code in it is marked already, all else is meant literally."""
    parts = re.split(r"(`[^`]*`)", re.sub(r"\s+", " ", text).strip())
    return "".join(p if p.startswith("`") else re.sub(r"([*_<>\[\]|\\])", r"\\\1", p) for p in parts)
