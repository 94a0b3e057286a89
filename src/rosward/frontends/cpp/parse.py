# SPDX-License-Identifier: Apache-2.0
"""Which syntax tree has a prepared file?

    class Lamp : public rclcpp::Node { … };      ->  a tree of tree-sitter, and what in it is no C++, by line

The tree is tree-sitter's own: what is lowered is walked once, and most of it never. What the parser does not understand costs the
statement around it, and is told. How much it may work is counted in its own steps, not in seconds, so that the answer is the same everywhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, final

from rosward.findings import Finding
from rosward.frontends.cpp.prepared import Prepared
from rosward.frontends.cpp.repaired import repaired
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits

if TYPE_CHECKING:
    from tree_sitter import Node, Parser, Tree

_STEPS: Final = 1_000
_STEPS_A_BYTE: Final = 0.06
"""Ordinary code takes 0.007, a sum of a hundred thousand numbers 0.04, nested template brackets 0.1 and much memory."""

_TOLD: Final = 50
_SHOWN: Final = 40
_CHUNK: Final = 4_096


class Trouble(NamedTuple):
    """The lines of a text that are no C++ to the parser; `missing` is what it would have expected, where that is all."""

    first: int
    last: int
    text: str
    missing: str = ""


class Parsed(NamedTuple):
    """A prepared file with its tree."""

    prepared: Prepared
    tree: Tree
    troubles: tuple[Trouble, ...] = ()

    def place(self, node: Node) -> Place:
        """Where a node stands in the source."""
        line, column = node.start_point
        return Place(self.prepared.file, line + 1, 1 if line + 1 in self.prepared.expanded else column + 1)

    @property
    def findings(self) -> list[Finding]:
        """What is to be told of it."""
        told: list[Finding] = []
        cause = (f"what cannot be read in {self.prepared.file}",)
        for trouble in self.troubles[:_TOLD]:
            what = f"expected {trouble.missing!r} here" if trouble.missing else f"{trouble.text!r} is not understood"
            told.append(
                Finding(
                    "RW206", f"This is no C++ that can be read: {what}", Place(self.prepared.file, trouble.first), cause
                )
            )
        return told


@final
class CppParser:
    """Parses each prepared file once. The parser is loaded when the first one is made, so that nobody else pays for it."""

    __slots__ = ("_parser", "_trees")

    def __init__(self) -> None:
        self._parser = _new_parser()
        self._trees: dict[int, tuple[Prepared, Parsed | Finding]] = {}

    def parse(self, prepared: Prepared) -> Parsed | Finding:
        """The tree of a file, or why there is none."""
        known = self._trees.get(id(prepared))
        if known is None:
            known = self._trees[id(prepared)] = prepared, self._parse(prepared)
        return known[1]

    def _parse(self, prepared: Prepared) -> Parsed | Finding:
        parsed = self._tree(prepared)
        if isinstance(parsed, Parsed) and parsed.troubles:
            text = repaired(prepared.text)
            if text != prepared.text:
                return self._tree(prepared._replace(text=text))
        return parsed

    def _tree(self, prepared: Prepared) -> Parsed | Finding:
        data = prepared.text.encode("utf-8", "replace")
        if len(data) > limits.CPP_FILE:
            return Finding(
                "RW003", f"The file is larger than {limits.CPP_FILE:,} bytes after preprocessing.", Place(prepared.file)
            )
        steps = int(len(data) * _STEPS_A_BYTE) + _STEPS

        def gives_up(_offset: int, _error: bool) -> bool:
            nonlocal steps
            steps -= 1
            return steps < 0

        try:
            tree = self._parser.parse(lambda offset, _point: data[offset : offset + _CHUNK], progress_callback=gives_up)
        except ValueError:  # it gave up
            self._parser.reset()
            return Finding("RW201", "The parser needs too much for this file: it is not read.", Place(prepared.file))
        return Parsed(prepared, tree, tuple(_troubles(tree.root_node)) if tree.root_node.has_error else ())


def _new_parser() -> Parser:
    import tree_sitter
    import tree_sitter_cpp

    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))


def _troubles(root: Node) -> Iterator[Trouble]:
    """What is not understood, each outermost node of it, in the order of the text. Without recursion: trees are as deep as their source."""
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.is_error or node.is_missing:
            text = (node.text or b"")[:_SHOWN].decode("utf-8", "replace")
            missing = node.type if node.is_missing else ""
            if (
                missing == "type_identifier"
                and node.parent is not None
                and node.parent.type == "compound_literal_expression"
            ):
                continue  # `= {}` as a default argument
            yield Trouble(node.start_point[0] + 1, node.end_point[0] + 1, " ".join(text.split()), missing)
        elif node.has_error:
            waiting += reversed(node.children)
