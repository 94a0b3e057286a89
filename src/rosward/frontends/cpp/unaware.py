# SPDX-License-Identifier: Apache-2.0
"""Which files of a program know nothing of ROS, and keep nothing between two calls?

    nlohmann/json.hpp, math/pose.hpp: they include the standard library, and such files     ->  unaware
    driver.hpp: it includes rclcpp; logger.hpp: driver.cpp defines a function of it         ->  not

Whoever calls a function of such a file with data can be told nothing of ROS by it: what it does shows in its result, and in what it was given.
Where that is in doubt a file is none of these.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Final

from rosward.frontends.cpp.model_headers import PREFIX, modelled
from rosward.frontends.cpp.symbol_file import FileSymbols
from rosward.ir.symbols import SymbolKind

_DATA: Final = re.compile(
    r"[a-z_]+|(?:std\w+|assert|ctype|errno|fcntl|fenv|float|getopt|inttypes|limits|locale|malloc|math|memory|poll|pthread|sched|semaphore|signal"
    r"|string|strings|termios|time|unistd|wchar)\.h|\w+/(?:msg|srv|action)/.*|.*\.pb\.h"
)
"""Headers from elsewhere that give data types: of the standard library, of messages, of protocol buffers."""
_LIBRARIES: Final = re.compile(
    r"(?:Eigen|GL|arpa|boost|cppunit|curl|fmt|google|gtest|linux|net|netinet|nlohmann|opencv2|openssl|spdlog|sys|tl|yaml-cpp)/.*"
)
"""Those of libraries that have nothing to do with ROS."""
_WORD: Final = re.compile(r"[A-Za-z_]\w*")
_LASTING: Final = re.compile(rb"\b(?:static|thread_local|extern)\b")
_CREATING: Final = frozenset({"publish", "advertise", "subscribe", "advertiseService", "NodeHandle"})
_NAMED: Final = frozenset({SymbolKind.CLASS, SymbolKind.FUNCTION, SymbolKind.VARIABLE})


def unaware(files: Sequence[FileSymbols]) -> frozenset[str]:
    """Those of a program, by the names that places have for them."""
    own = [file for file in files if not file.parsed.prepared.file.startswith(PREFIX)]
    words = {file: found for file in own if (found := _words(file)) is not None and not _keeps_something(file)}
    left, aware = list(words), [file for file in own if file not in words]
    while aware and left:  # what these declare the others may call
        names = {name for file in aware for name in _names(file)}
        paths = {file.parsed.prepared.path for file in aware}
        aware = [f for f in left if not words[f].isdisjoint(names) or not paths.isdisjoint(f.parsed.prepared.includes)]
        left = [file for file in left if file not in set(aware)]
    return frozenset(file.parsed.prepared.file for file in left)


def _words(file: FileSymbols) -> set[str] | None:
    """The words of a file; None where it may say something of ROS."""
    prepared = file.parsed.prepared
    if prepared.registrations or not all(_DATA.fullmatch(n) or _LIBRARIES.fullmatch(n) for n in prepared.external):
        return None
    words = set(_WORD.findall(prepared.text))
    if not words.isdisjoint(modelled() | _CREATING) or any(word.startswith("create_") for word in words):
        return None
    return words


def _names(file: FileSymbols) -> set[str]:
    """What others may name of it: its classes, functions and variables, and the classes of which it defines members."""
    found = {each.name for each in file.outline.declared if each.kind in _NAMED and not each.before}
    for scope, names in file.elsewhere.items():
        for name, symbols in names.items():
            found.add(scope[-1] if scope and any(map(file.in_class, symbols)) else name)
    return found


def _keeps_something(file: FileSymbols) -> bool:
    """Whether a variable of it outlives a call."""
    if any(not symbol.constant for symbol in file.variables):
        return True
    text = file.parsed.prepared.text.encode("utf-8", "replace")
    root = file.parsed.tree.root_node
    for match in _LASTING.finditer(text):
        node = root.descendant_for_byte_range(*match.span())
        while node is not None and not node.type.endswith(("declaration", "definition", "linkage_specification")):
            node = node.parent
        if node is None:
            return True
        if node.type in ("function_definition", "linkage_specification"):
            continue
        parent = node.parent
        local = parent is not None and parent.type == "compound_statement"
        words = set(re.findall(rb"\w+", (node.text or b"").partition(b"=")[0]))
        declares_function = not local and any("function_declarator" in each.type for each in node.children)
        if not declares_function and words.isdisjoint({b"const", b"constexpr"}):
            return True
    return False
