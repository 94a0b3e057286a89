# SPDX-License-Identifier: Apache-2.0
"""Which files of a program know nothing of ROS, and keep nothing between two calls?

    nlohmann/json.hpp, math/pose.hpp: they include the standard library, and such files     ->  unaware
    driver.hpp: it includes rclcpp; logger.hpp: driver.cpp defines a function of it         ->  not

Whoever calls a function of such a file with data can be told nothing of ROS by it: what it does shows in its result, and in what it was given.
Where that is in doubt a file is none of these.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Final

from rosward.frontends.cpp.model_headers import PREFIX, modelled
from rosward.frontends.cpp.symbol_file import FileSymbols
from rosward.ir.symbols import Scope, SymbolKind

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
_LEADING: Final = re.compile(r"\*|\b(?:auto|mutable|any|reference_wrapper|Ptr|SharedPtr|\w*_ptr|\w*function)\b")
"""What is of such a type, or has something of it, may lead to what changes though it is a constant."""
_ARGUMENTS: Final = re.compile(r"<[^<>]*>")
_ATTRIBUTE: Final = re.compile(r"\[\[[^\[\]]*\]\]")
_CREATING: Final = frozenset({"publish", "advertise", "subscribe", "advertiseService", "NodeHandle"})
_RENAMING: Final = frozenset({SymbolKind.USING, SymbolKind.ALIAS})
_NAMED: Final = frozenset({SymbolKind.CLASS, SymbolKind.FUNCTION, SymbolKind.VARIABLE})


def unaware(files: Sequence[FileSymbols]) -> dict[str, frozenset[Scope]]:
    """Those of a program, by the names that places have for them, with the namespaces of which they must not be handed anything.

    They call a function of such a namespace where it is found by its arguments: `to_json(json, value)` in nlohmann/json.hpp.
    """
    own = [file for file in files if not file.parsed.prepared.file.startswith(PREFIX)]
    leading = {name for file in own for name, text in _classes(file) if _LEADING.search(text)}
    words = {f: found for f in own if (found := _words(f)) is not None and not _keeps_something(f, leading)}
    classes = {name for file in words for name, _ in _classes(file)}
    opened, renamed = _opened(own), _renamed(own)
    by_arguments: dict[FileSymbols, set[Scope]] = {file: set() for file in words}
    left, aware = list(words), [file for file in own if file not in words]
    while aware and left:  # what these declare the others may call
        names = _reached(aware, opened, renamed)
        for name in set().union(*(classes.intersection(_operands(file)) for file in aware)):
            names.setdefault(name, {})[()] = False
        paths = {file.parsed.prepared.path for file in aware}
        aware = []
        for file in left:
            said = [(s, f) for n in words[file].intersection(names) for s, f in names[n].items()]
            if not paths.isdisjoint(file.parsed.prepared.includes) or any(_sees(words[file], s) for s, _ in said):
                aware.append(file)
            by_arguments[file].update(scope for scope, is_function in said if is_function)
        left = [file for file in left if file not in set(aware)]
    return _with_included(left, by_arguments)


def _sees(words: set[str], scope: Scope) -> bool:
    """Whether what is declared in a namespace can be named in a file: the file opens the namespace, or says its name."""
    return not scope or scope[0] in words


def _reached(
    aware: Sequence[FileSymbols], opened: set[Scope], renamed: dict[str, set[Scope]]
) -> dict[str, dict[Scope, bool]]:
    """The names that files declare, by the namespaces in which they are found: whether of functions."""
    found: dict[str, dict[Scope, bool]] = {}
    for file in aware:
        for name, scope, is_function in _names(file):
            within = tuple(filter(None, scope))  # what stands in an unnamed namespace is seen around it
            scopes = found.setdefault(name, {})
            scopes[within] = scopes.get(within, False) or is_function
            if within in opened:
                scopes.setdefault((), False)
    for name, scopes in found.items():
        for scope in renamed.get(name, ()):
            scopes.setdefault(scope, False)
    return found


def _renamed(files: Sequence[FileSymbols]) -> dict[str, set[Scope]]:
    """By name, the namespaces in which it is known, too: `using lamp::light;`."""
    found: dict[str, set[Scope]] = {}
    for file in files:
        for each in file.outline.declared:
            if each.kind in _RENAMING:
                found.setdefault(each.name, set()).add(tuple(filter(None, each.scope)))
    return found


def _opened(files: Sequence[FileSymbols]) -> set[Scope]:
    """The namespaces of which headers make the names seen elsewhere. (In a source, it stands behind what the source includes.)"""
    kinds = (SymbolKind.USING_NAMESPACE, SymbolKind.NAMESPACE_ALIAS)
    renamed = [each for file in files if not file.source for each in file.outline.declared if each.kind in kinds]
    said = {word for each in renamed for word in _WORD.findall((each.whole.text or b"").decode("utf-8", "replace"))}
    named = {scope for file in files for scope in file.outline.spaces if scope and scope[-1] in said}
    return named.union(*(file.outline.inlines for file in files))


def _with_included(
    files: Sequence[FileSymbols], by_arguments: dict[FileSymbols, set[Scope]]
) -> dict[str, frozenset[Scope]]:
    """The namespaces of each file, with those of all that it includes: its functions may call theirs."""
    by_path = {file.parsed.prepared.path: file for file in files}
    found: dict[str, frozenset[Scope]] = {}
    for file in files:
        reached, waiting = {file}, [file]
        while waiting:
            paths = waiting.pop().parsed.prepared.includes
            more = {by_path[path] for path in paths if path in by_path} - reached
            reached |= more
            waiting += more
        found[file.parsed.prepared.file] = frozenset().union(*(by_arguments[each] for each in reached))
    return found


def _classes(file: FileSymbols) -> Iterator[tuple[str, str]]:
    """The classes that a file declares, with what is written there."""
    for each in file.outline.declared:
        if each.kind is SymbolKind.CLASS:
            yield each.name, (each.node.text or b"").decode("utf-8", "replace")


def _words(file: FileSymbols) -> set[str] | None:
    """The words of a file; None where it may say something of ROS."""
    prepared = file.parsed.prepared
    if prepared.registrations or not all(_DATA.fullmatch(n) or _LIBRARIES.fullmatch(n) for n in prepared.external):
        return None
    words = set(_WORD.findall(prepared.text))
    if not words.isdisjoint(modelled() | _CREATING) or any(word.startswith("create_") for word in words):
        return None
    return words


def _names(file: FileSymbols) -> Iterator[tuple[str, Scope, bool]]:
    """What others may name of it: its classes, functions and variables, and the classes of which it defines members. With each, the namespace
    in which it is found, and whether it is a function."""
    for each in file.outline.declared:
        if each.kind in _NAMED and not each.before:
            yield each.name, each.scope, each.kind is SymbolKind.FUNCTION
    for scope, names in file.elsewhere.items():
        for name, symbols in names.items():
            of_class = scope and any(map(file.in_class, symbols))
            if not of_class or any(symbol.kind is SymbolKind.CLASS for symbol in symbols):
                yield name, scope, any(symbol.kind is SymbolKind.FUNCTION for symbol in symbols)
            if of_class:
                yield scope[-1], scope[:-1], False


def _operands(file: FileSymbols) -> set[str]:
    """What its operators outside of classes are of: they are called where nobody says their names."""
    texts = [each.whole.text or b"" for each in file.outline.declared if each.name.startswith("operator")]
    return {word for text in texts for word in _WORD.findall(text.partition(b"{")[0].decode("utf-8", "replace"))}


def _keeps_something(file: FileSymbols, leading: set[str]) -> bool:
    """Whether a variable of it outlives a call."""
    for symbol in file.variables:
        whole = (symbol.declared.whole.text or b"").decode("utf-8", "replace")
        if not symbol.constant or not _is_constant(whole, leading):
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
        declares_function = not local and any("function_declarator" in each.type for each in node.children)
        if not declares_function and not _is_constant((node.text or b"").decode("utf-8", "replace"), leading):
            return True
    return False


def _is_constant(declaration: str, leading: set[str]) -> bool:
    """Whether a variable never changes, nor what it leads to: `const char * const NAME`, not `const char * name` or `Box * const box`.

    `leading`: classes of which constants may lead to something else.
    """
    written = re.split(r"[={(\[]", _ATTRIBUTE.sub("", declaration), maxsplit=1)[0]
    if re.search(r"\bconstexpr\b", written):
        return True
    if _LEADING.search(written.replace("*", "")) or not leading.isdisjoint(_WORD.findall(written)):
        return False
    while (shorter := _ARGUMENTS.sub("", written)) != written:
        written = shorter
    return all(re.search(r"\bconst\b", part) for part in written.split("*"))
