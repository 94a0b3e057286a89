# SPDX-License-Identifier: Apache-2.0
"""What do the commands say that make targets, and say how these are compiled and linked?

    add_executable(talker src/talker.cpp)
    target_compile_definitions(talker PRIVATE RATE=5)      ->  a target talker with that source and that macro

What is said of a folder (`include_directories`) holds for its targets, and for those of the folders below that are entered later.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final, final

from rosward.source import disk, limits
from rosward.source.cmake.blocks import Way
from rosward.source.cmake.generators import meant, objects_of
from rosward.source.cmake.interpreter import Interpreter
from rosward.source.cmake.reader import Handler
from rosward.source.cmake.standards import of_features, of_options, of_standard
from rosward.source.cmake.targets import UNKNOWN_VALUE, Definition, Made, Making, Using
from rosward.source.cmake.text import Command
from rosward.source.cmake.variables import HOLE
from rosward.source.text import read_bytes
from rosward.source.walk import CPP_SOURCES

_VISIBLE: Final = frozenset(
    {"PUBLIC", "PRIVATE", "INTERFACE", "LINK_PUBLIC", "LINK_PRIVATE", "LINK_INTERFACE_LIBRARIES"}
)
_KINDS: Final[Mapping[str, Made]] = {
    "STATIC": Made.LIBRARY, "SHARED": Made.LIBRARY, "MODULE": Made.LIBRARY, "OBJECT": Made.OBJECTS, "INTERFACE": Made.INTERFACE,
    "UNKNOWN": Made.LIBRARY,
}  # fmt: skip
_NO_SOURCE: Final = frozenset(
    {"WIN32", "MACOSX_BUNDLE", "EXCLUDE_FROM_ALL", "NO_TARGET_LINK_LIBRARIES", "PRIVATE", "PUBLIC", "BEFORE", "SYSTEM", "AFTER"}
)  # fmt: skip
_TARGET_LIMIT: Final = 2_000
_MAKES: Final = re.compile(
    r"(?:add|make|build|create).*?(executable|program|binary|node|app|lib|component|plugin|module|target|package)"
)
_MAKES_NOT: Final = re.compile(
    r"test|mock|benchmark|custom|lint|check|dependenc|flag|definition|option|include|install|doc|python|pybind"
)
_MAIN: Final = re.compile(rb"\bmain\s*\(")


@final
class TargetCommands:
    """The targets of a package in the course of being read; `found` are the packages that have been found."""

    def __init__(self, interpreter: Interpreter, top: str, found: Mapping[str, None]) -> None:
        self._interpreter = interpreter
        self._top = top
        self._found = found
        self._folders: dict[str, Using] = {top: Using()}
        self.made: dict[str, Making] = {}
        self.aliases: dict[str, str] = {}
        self.handlers: Mapping[str, Handler] = {
            "add_executable": self._add_executable,
            "cuda_add_executable": self._add_executable,
            "ament_auto_add_executable": self._add_executable,
            "add_library": self._add_library,
            "cuda_add_library": self._add_library,
            "ament_auto_add_library": self._add_library,
            "target_sources": self._target_sources,
            "target_link_libraries": self._target_links,
            "ament_target_dependencies": self._target_depends,
            "target_include_directories": self._target_includes,
            "target_compile_definitions": self._target_definitions,
            "target_compile_options": self._target_options,
            "target_compile_features": self._target_features,
            "set_target_properties": self._properties,
            "set_property": self._property,
            "include_directories": self._folder_includes,
            "add_compile_definitions": self._folder_definitions,
            "add_definitions": self._folder_options,
            "add_compile_options": self._folder_options,
            "link_libraries": self._folder_links,
        }

    @property
    def sure(self) -> bool:
        """Whether what is read now happens whatever the conditions are that nobody knows."""
        return not self._interpreter.undecided

    def folder(self) -> Using:
        """What all targets of the folder use that is read: at first what the folder above it uses."""
        folder = self._interpreter.folder
        if folder not in self._folders:
            above = folder
            while above not in self._folders:
                above = os.path.dirname(above)  # noqa: PTH120
            self._folders[folder] = self._folders[above].copy()
        return self._folders[folder]

    def find(self, name: str) -> Making | None:
        """The target of that name, or alias."""
        return self.made.get(self.aliases.get(name, name))

    def add(self, name: str, made: Made, sources: Sequence[str], command: Command) -> None:
        """Make a target, or add sources to it."""
        if HOLE in name:
            paths = (self._interpreter.inside(source) for source in sources if HOLE not in source)
            if made is Made.PROGRAM and any(path is not None and disk.is_file(path) for path in paths):
                self._interpreter.doubt("The name of this program is not known: it is missing.", command)
            return
        if len(self.made) >= _TARGET_LIMIT:
            return
        target = self.made.get(name)
        if target is None:
            within = tuple(self._interpreter.undecided)
            target = Making(name, made, self._interpreter.place(command), self.sure, self.folder(), within)
            variables = self._interpreter.variables
            target.own.standards += of_standard(variables.get("CMAKE_CXX_STANDARD"))
            target.own.standards += of_options([variables.get("CMAKE_CXX_FLAGS")])
            target.own.standards += self.folder().standards
            self.made[name] = target
        else:
            target.made_again(sure=self.sure)
        if command.name.startswith("ament_auto_"):
            sources = list(self._automatic(target, sources))
        self._put(target, sources)

    def _add_executable(self, arguments: list[str], command: Command) -> None:
        name, *sources = arguments
        if self._is_own(name, sources):
            self.add(name, Made.PROGRAM, sources, command)
            if command.name == "ament_auto_add_executable" and name in self.made:
                self.made[name].installed = True

    def _add_library(self, arguments: list[str], command: Command) -> None:
        name, *sources = arguments
        if self._is_own(name, sources):
            made = next((_KINDS[s] for s in sources[:2] if s in _KINDS), Made.LIBRARY)
            self.add(name, made, [s for s in sources if s not in _KINDS], command)

    def unknown(self, arguments: list[str], command: Command) -> None:
        """A command that nothing defines, of which the name says that it makes a target, and that sources are given to:
        `demo_add_library(TARGET core SOURCES src/a.cpp)`. It is a program where one of them has `main`."""
        if not _MAKES.search(command.name) or _MAKES_NOT.search(command.name):
            return
        sources = [a for a in arguments if a.endswith(CPP_SOURCES) and self._is_file(a)]
        names = [a for a in arguments if a not in sources and not a.isupper() and HOLE not in a]
        if not sources or not names:
            return
        marked = next((n for n, a in enumerate(arguments[:-1]) if a in {"TARGET", "NAME"}), -1)
        name = arguments[marked + 1] if marked >= 0 else names[0]
        made = Made.PROGRAM if any(map(self._has_main, sources)) else Made.LIBRARY
        self.add(name, made, sources, command)
        if name in self.made:
            self.made[name].installed = True

    def _is_file(self, text: str) -> bool:
        path = self._interpreter.inside(text)
        return path is not None and disk.is_file(path)

    def _has_main(self, text: str) -> bool:
        data = read_bytes(self._interpreter.inside(text) or "", text, limits.CMAKE_FILE)
        return isinstance(data, bytes) and _MAIN.search(data) is not None

    def _is_own(self, name: str, words: Sequence[str]) -> bool:
        """Whether the words behind a name make a target of the package: neither another name of one, nor one from elsewhere."""
        if "ALIAS" in words[:1]:
            self.aliases[name] = "".join(words[1:2])
            return False
        return "IMPORTED" not in words[:2]

    def _automatic(self, target: Making, sources: Sequence[str]) -> Iterator[str]:
        """What `ament_auto_add_*` does for a target: folders of sources, the folder of headers, links to all that was found."""
        include = os.path.join(self._top, "include")  # noqa: PTH118
        if disk.is_folder(include):
            target.own.includes[include] = None
            target.handed.includes[include] = None
        links = [f"{package}::*" for package in self._found]
        if "NO_TARGET_LINK_LIBRARIES" not in sources and target.made is Made.PROGRAM:
            links += [name for name, other in self.made.items() if other.made is Made.LIBRARY]
        target.own.links |= dict.fromkeys(links)
        target.handed.links |= dict.fromkeys(links)
        into_folders = False
        for source in sources:
            if source == "DIRECTORY":
                into_folders = True
            elif into_folders:
                start = self._interpreter.inside(source)
                if start is not None:
                    yield from self._interpreter.files.glob(f"{start}{os.sep}*", recurse=False)
            else:
                yield source

    def _put(self, target: Making, sources: Iterable[str]) -> None:
        """Add sources to a target."""
        for argument in sources:
            if argument in _NO_SOURCE or argument in _VISIBLE:
                continue
            text, _ = meant(argument)
            objects = objects_of(text)
            if objects is not None:
                target.objects[objects] = None
            elif text and text != HOLE:
                self._source(target, text)

    def _source(self, target: Making, text: str) -> None:
        """Add one source, which may be named without its suffix."""
        path = None if HOLE in text else self._interpreter.inside(text)
        is_named = text.endswith(CPP_SOURCES)
        candidates = [path] if is_named else [f"{path}{suffix}" for suffix in CPP_SOURCES]
        for candidate in candidates if path is not None and (is_named or "." not in text.rpartition("/")[2]) else ():
            if candidate is not None and disk.is_file(candidate):
                target.sources[candidate] = None
                return
        if is_named:
            target.missing[text.replace(HOLE, "*")] = None

    def _target_sources(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        target = self.find(arguments[0])
        if target is not None:
            self._put(target, arguments[1:])

    def _by_visibility(self, arguments: list[str]) -> Iterator[tuple[list[Using], str]]:
        """Each argument with where it belongs: to the target, to those that link against it, or to both."""
        target = self.find(arguments[0])
        if target is None:
            return
        both = [target.own, target.handed]
        into = both
        for argument in arguments[1:]:
            if argument in _VISIBLE:
                into = both if "PUBLIC" in argument else [target.own] if "PRIVATE" in argument else [target.handed]
            elif argument not in {"SYSTEM", "BEFORE", "AFTER"}:
                yield into, argument

    def _target_links(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        sure = self._is_sure(self._within(arguments[0]))
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.link(self._links([argument]), sure=sure)

    def _target_depends(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        sure = self._is_sure(self._within(arguments[0]))
        for into, argument in self._by_visibility(arguments):
            if HOLE not in argument:
                for using in into:
                    using.link([f"{argument}::*"], sure=sure)

    def _target_includes(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        for into, argument in self._by_visibility(arguments):
            for using in into:
                self._include([argument], using)

    def _target_definitions(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        within = self._within(arguments[0])
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.definitions |= self._definitions([argument], within)

    def _target_options(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        within = self._within(arguments[0])
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.definitions |= self._definitions((a for a in [argument] if a.startswith("-D")), within)
                using.standards += of_options([argument], sure=self._is_sure(within))

    def _target_features(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        sure = self._is_sure(self._within(arguments[0]))
        for into, argument in self._by_visibility(arguments):
            for using in into:
                using.standards += of_features([argument], sure=sure)

    def _properties(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        """`set_target_properties(a b PROPERTIES COMPILE_DEFINITIONS X=1 …)`."""
        if "PROPERTIES" not in arguments:
            return
        at = arguments.index("PROPERTIES")
        pairs = dict(zip(arguments[at + 1 :: 2], arguments[at + 2 :: 2], strict=False))
        texts = [*pairs.get("COMPILE_DEFINITIONS", "").split(";")]
        texts += [flag for flag in pairs.get("COMPILE_FLAGS", "").split() if flag.startswith("-D")]
        for target in map(self.find, arguments[:at]):
            if target is not None:
                target.output = pairs.get("OUTPUT_NAME", target.output)
                target.own.definitions |= self._definitions((t for t in texts if t), target.within)
                sure = self._is_sure(target.within)
                options = (pairs.get("COMPILE_FLAGS", ""), pairs.get("COMPILE_OPTIONS", ""))
                target.own.standards += of_standard(pairs.get("CXX_STANDARD", ""), sure=sure)
                target.own.standards += of_options(options, sure=sure)

    def _property(self, arguments: list[str], command: Command) -> None:
        """`set_property(TARGET a b APPEND PROPERTY COMPILE_DEFINITIONS X=1 Y)`."""
        if arguments[0] == "TARGET" and "PROPERTY" in arguments[:-1]:
            at = arguments.index("PROPERTY")
            targets = [a for a in arguments[1:at] if a not in {"APPEND", "APPEND_STRING"}]
            self._properties([*targets, "PROPERTIES", arguments[at + 1], ";".join(arguments[at + 2 :])], command)

    # What all targets of a folder use

    def _folder_includes(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self._include([a for a in arguments if a not in {"SYSTEM", "BEFORE", "AFTER"}], self.folder())

    def _folder_definitions(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self.folder().definitions.update(self._definitions(arguments))

    def _folder_options(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self.folder().definitions.update(self._definitions(a for a in arguments if a.startswith("-D")))
        self.folder().standards += of_options(arguments, sure=self.sure)

    def _folder_links(self, arguments: list[str], command: Command) -> None:  # noqa: ARG002
        self.folder().links.update(self._links(arguments))

    def _include(self, paths: Iterable[str], into: Using) -> None:
        for argument in paths:
            text, _ = meant(argument)
            path = None if HOLE in text or not text else self._interpreter.inside(text)
            if path is not None:
                into.includes[path] = None
            elif "::" in text:
                into.links[text] = None

    def _is_sure(self, within: tuple[Way, ...]) -> bool:
        """Whether what is read now happens wherever these ways are taken."""
        return all(way in within for way in self._interpreter.undecided)

    def _within(self, name: str) -> tuple[Way, ...]:
        target = self.find(name)
        return target.within if target is not None else ()

    def _definitions(self, texts: Iterable[str], within: tuple[Way, ...] = ()) -> dict[Definition, None]:
        """The macros that arguments define, of what stands itself `within` these ways."""
        found: dict[Definition, None] = {}
        known = self._is_sure(within)
        for argument in texts:
            text, sure = meant(argument)
            name, equals, value = text.removeprefix("-D").partition("=")
            if name.isidentifier():
                value = value.replace('\\"', '"')
                is_open = HOLE in value and not value.startswith('"')  # a number: a text is known in part
                sure = sure and known and (is_open or HOLE not in value)
                value = UNKNOWN_VALUE if is_open else value.replace(HOLE, "")
                found[Definition(name, value if equals else "1", sure)] = None
        return found

    @staticmethod
    def _links(arguments: Iterable[str]) -> dict[str, None]:
        texts = (meant(argument).text for argument in arguments)
        return {
            t: None
            for t in texts
            if t and HOLE not in t and not t.startswith("-") and t not in {"debug", "optimized", "general"}
        }
