# SPDX-License-Identifier: Apache-2.0
"""The summary on the terminal: what was found, how sure the names are, and every doubt with what to do about it.

    rosward read 2 files (120 lines) for jazzy: 2 nodes in 2 processes.

      nodes 2 · topics 4 (2 system) · services 15 (14 system) · actions 1
      names 6: 3 exact, 1 default, 1 pattern, 1 unknown

    error RW101 unknown name: 1
      src/demo/node.py:60  publisher of node /listener: sys.argv[1] is not known
      Supply the value that is missing: a default, a parameter file, an argument.

Where no terminal shows it, it is plain text, without colours and without cutting lines (`paper.py`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from rosward.explanation.doubts import Doubts, doubts
from rosward.findings import Finding
from rosward.network.counts import Count, Counts, counts_of
from rosward.network.graph import Network
from rosward.one_cause import by_cause, more_of
from rosward.outputs.terminal.paper import Paper
from rosward.records import NamedTuple
from rosward.ros.entities import Interface, Resolution
from rosward.rules import Severity
from rosward.safe import printable
from rosward.suppression.judge import Reviewed

__all__ = ["Unread", "summary"]

_NOTHING_ASIDE: Final = Reviewed(())
_SHOWN: Final = 5
"""How many findings of one rule are shown when not verbose."""

_COLOURS: Final = {Severity.ERROR: "bold red", Severity.WARNING: "yellow", Severity.NOTE: "cyan"}
_KNOWLEDGE: Final = {Interface.PARTIAL: "yellow", Interface.UNKNOWN: "bold red"}
_SURENESS: Final = {Resolution.PATTERN: "yellow", Resolution.UNKNOWN: "bold red"}


class Unread(NamedTuple):
    """How much is there and not in the network: files and folders that patterns exclude, folders that are marked to be ignored,
    launch files that nobody asked for."""

    excluded: int = 0
    ignored: int = 0
    launch_files: int = 0


_ALL_READ: Final = Unread()


def summary(
    network: Network,
    paper: Paper,
    verbose: bool = False,
    written: Sequence[str] = (),
    reviewed: Reviewed = _NOTHING_ASIDE,
    configuration: str | None = None,
    unread: Unread = _ALL_READ,
) -> None:
    """Print the summary.

    `verbose` lists every finding, notes too; `written` are the paths of what was written. Of `reviewed`, what is ignored or known is counted;
    `configuration` is the file that set options.
    """
    counts = counts_of(network)
    paper.line(_head(network, counts))
    if configuration is not None:
        paper.line(("  options of " + printable(configuration), "dim"))
    for line in _left_out(unread):
        paper.line(line)
    paper.line()
    paper.line(("  ", ""), *_things(counts))
    paper.line(("  ", ""), *_names(counts))
    if counts.nodes > counts.interfaces[Interface.ANALYSED]:
        paper.line(("  ", ""), *_interfaces(counts))
    if counts.assumed:
        assumed = _several(counts.assumed, "node is", "nodes are")
        paper.line((f"  {assumed} assumed: nothing starts {'it' if counts.assumed == 1 else 'them'}", "yellow"))
    for group in doubts(network.findings):
        if verbose or group.rule.severity is not Severity.NOTE:
            paper.line()
            _group(paper, group, verbose)
    paper.line()
    paper.line(*_verdict(counts, verbose, reviewed))
    for path in written:
        paper.line(("  ", ""), (printable(path), "dim"))


def _head(network: Network, counts: Counts) -> tuple[str, str]:
    read = f"{_several(network.files, 'file')} ({_several(network.lines, 'line')})"
    found = f"{_several(counts.nodes, 'node')} in {_several(network.processes, 'process', 'processes')}"
    return (f"rosward read {read} for {network.distro}: {found}.", "bold")


def _left_out(unread: Unread) -> Iterator[tuple[str, str]]:
    if unread.excluded:
        things = _several(unread.excluded, "file or folder", "files and folders")
        yield f"  not read: {things} excluded by a pattern (use -v to list)", "yellow"
    if unread.ignored:
        folders = _several(unread.ignored, "folder")
        yield f"  not read: {folders} marked as ignored, for example by COLCON_IGNORE (use -v to list)", "yellow"
    if unread.launch_files:
        files = _several(unread.launch_files, "launch file was", "launch files were")
        yield f"  {files} not analysed; use --launch FILE or --all-launch", "dim"


def _things(counts: Counts) -> list[tuple[str, str]]:
    parts = [(f"nodes {counts.nodes}", "")]
    for word, count in (("topics", counts.topics), ("services", counts.services), ("actions", counts.actions)):
        parts += [(" · ", "dim"), (f"{word} {count.total:,}", ""), (_of_which(count), "dim")]
    return parts


def _of_which(count: Count) -> str:
    return f" ({count.system:,} system)" if count.system else ""


def _names(counts: Counts) -> list[tuple[str, str]]:
    total = sum(counts.names.values())
    parts = [(f"names {total:,}", "")]
    separator = ": "
    for resolution, number in counts.names.items():
        if number:
            parts += [(separator, ""), (f"{number:,} {resolution.value}", _SURENESS.get(resolution, ""))]
            separator = ", "
    return parts


_WORDS: Final = {Interface.PARTIAL: "partially known"}


def _interfaces(counts: Counts) -> list[tuple[str, str]]:
    """How much is known of the nodes; not told where each was analysed."""
    parts = [(_several(counts.nodes, "node"), "")]
    separator = ": "
    for interface, number in counts.interfaces.items():
        if number:
            colour = _KNOWLEDGE.get(interface, "")
            parts += [(separator, ""), (f"{number:,} {_WORDS.get(interface, interface.value)}", colour)]
            separator = ", "
    return parts


def _group(paper: Paper, group: Doubts, verbose: bool) -> None:
    rule = group.rule
    title = f" {rule.code} {rule.title}: {len(group.causes):,}"
    paper.line((rule.severity.value, _COLOURS[rule.severity]), (title, "bold"))
    shown = group.causes if verbose else group.causes[:_SHOWN]
    for one in shown:
        more = more_of(one)
        _finding(paper, one.finding, "" if verbose or not more else f" (and {more})")
        for finding in one.also if verbose else ():
            _finding(paper, finding, of=rule.code)
    if len(shown) < len(group.causes):
        paper.line((f"  … and {len(group.causes) - len(shown):,} more (use -v to list all)", "dim"))
    if not all(one.finding.remedy for one in shown):
        paper.line(("  " + rule.help, "italic"))


def _finding(paper: Paper, finding: Finding, more: str = "", of: str | None = None) -> None:
    """A finding on its line; further in, with its code where that is another one, what has the cause of a finding with the code `of`."""
    place, message = printable(str(finding.place)), printable(finding.message)
    code = "" if of in (None, finding.code) else f"{finding.code} "
    paper.line(("    " if of else "  ", ""), (place, "cyan"), (f"  {code}{message}", ""), (more, "dim"))


def _verdict(counts: Counts, verbose: bool, reviewed: Reviewed) -> list[tuple[str, str]]:
    errors = counts.severities[Severity.ERROR]
    warnings = counts.severities[Severity.WARNING]
    notes = counts.severities[Severity.NOTE]
    known = sum(one.finding.rule.severity is Severity.ERROR for one in by_cause(reviewed.known))
    if errors:
        parts = [("Incomplete: ", "bold red"), (_several(errors, "error"), "")]
    elif reviewed.accepted or known:  # the result lacks something, and somebody said that this is known
        old = [(reviewed.accepted, "accepted"), (known, "in the baseline")]
        told = ", ".join(f"{_several(number, 'error')} {word}" for number, word in old if number)
        parts = [("Incomplete (known): ", "bold yellow"), (told, "")]
    else:
        parts = [("Complete", "bold green"), (": no errors", "")]
    parts.append((f", {_several(warnings, 'warning')}", ""))
    if notes:
        parts.append((f", {_several(notes, 'note')}" + ("" if verbose else " (use -v to show notes)"), ""))
    for number, word in ((reviewed.ignored, "ignored"), (len(reviewed.known), "in the baseline")):
        if number:
            parts.append((f", {number:,} {word}", "dim"))
    return [*parts, (".", "")]


def _several(number: int, word: str, plural: str = "") -> str:
    return f"{number:,} {word if number == 1 else plural or word + 's'}"
