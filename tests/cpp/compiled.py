# SPDX-License-Identifier: Apache-2.0
"""What does a C++ program create when it runs? It is compiled against a double of rclcpp (`double/`), and run.

    run_source(text, folder).entities    ->  [("/talker", "node", "/talker", ""), ("/talker", "pub", "/chatter", "std_msgs/msg/String"), …]

The double is built once for all: its library, and a precompiled header, so that a program takes about a second.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Container, Iterable, Sequence
from functools import cached_property
from pathlib import Path
from typing import Final, NamedTuple

import pytest

from .messages import Headers

HERE: Final = Path(__file__).parent / "double"
COMPILER: Final = shutil.which("g++")
_REQUIRED: Final = "g++" in os.environ.get("ROSWARD_TESTS_REQUIRE", "").split()
needs_compiler: Final = pytest.mark.skipif(
    COMPILER is None and not _REQUIRED, reason="no g++ here (.ci/run installs it)"
)
_FLAGS: Final = ("-std=c++17", "-O0", "-w", "-pipe")
_PRECOMPILED: Final = """#pragma once
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_map>
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
"""
_WHOLE: Final = {
    "message_filters": "message_filters/synchronizer.h",
    "rclcpp": "rclcpp/rclcpp.hpp",
    "rclcpp_action": "rclcpp_action/rclcpp_action.hpp",
    "rclcpp_lifecycle": "rclcpp_lifecycle/lifecycle_node.hpp",
    "tf2_ros": "tf2_ros/tf2_ros.h",
}
"""The header in which the double has all of a package: the others of the package are written when they are asked for."""
_FORWARDED: Final = re.compile(rf'^\s*#\s*include\s*[<"]((?:{"|".join(_WHOLE)})/[\w/]+\.h(?:pp)?)[>"]', re.MULTILINE)
_LINE: Final = re.compile(r"^@double (.*)$", re.MULTILINE)
_INCLUDE: Final = re.compile(r"^[ \t]*#[ \t]*include\b.*$", re.MULTILINE)
_OF_A_LIBRARY: Final = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"](Q[A-Z]\w*|\w+/[^">\n]+)[">]', re.MULTILINE)
_ALONE: Final = re.compile(
    r"^[ \t]*#[ \t]*(?:define|undef|if|ifdef|ifndef)\b|(?<![\w>:\s])\s*::\w|\b(?:struct|class)\s+\w+::|^namespace (?:std|rclcpp)\b",
    re.MULTILINE,
)
"""What has another meaning in a namespace beside other programs: macros, names of the global namespace, specialisations for a library."""
PROGRAM: Final = re.compile(r"^@double begin$(.*?)^@double end (\d+)$", re.MULTILINE | re.DOTALL)
_SECONDS: Final = 300

Fact = tuple[str, str, str, str]
"""The full name of a node, the word for the kind, the full name of the entity, its type."""


class Ran(NamedTuple):
    """What a program did: what it created in that order, what the library did for it, the exit status, what it printed."""

    entities: list[Fact]
    system: list[Fact]
    status: int
    output: str

    @property
    def facts(self) -> frozenset[Fact]:
        """What it created, without the nodes."""
        return frozenset(fact for fact in self.entities if fact[1] != "node")

    @property
    def nodes(self) -> frozenset[str]:
        """The full names of its nodes."""
        return frozenset(node for node, kind, *_ in self.entities if kind == "node")


class Double:
    """The double, built: a folder with the headers of interfaces, the precompiled header and the library."""

    def __init__(self, compiler: str) -> None:
        self._compiler = compiler

    @cached_property
    def folder(self) -> Path:
        """Where it is; built if nobody did so before."""
        digest = hashlib.sha256(f"{self._compiler} {_FLAGS} {_PRECOMPILED}".encode())
        files = [file for file in HERE.rglob("*") if file.is_file()]
        for file in [*sorted(files), Path(__file__), Path(__file__).with_name("messages.py")]:
            digest.update(file.read_bytes())
        built = Path(tempfile.gettempdir()) / f"rosward-double-{os.getuid()}-{digest.hexdigest()[:16]}"
        with built.with_suffix(".lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # of several processes one builds it
            if not built.exists():
                with tempfile.TemporaryDirectory(dir=built.parent, prefix="rosward-double-") as made:
                    self._build(Path(made))
                    Path(made).rename(built)
                    Path(made).mkdir()
        return built

    @cached_property
    def headers(self) -> Headers:
        """The headers of interfaces that programs include."""
        return Headers(self.folder / "include")

    def _build(self, folder: Path) -> None:
        include = folder / "include"
        include.mkdir()
        headers = Headers(include)
        for file in [*HERE.rglob("*.hpp"), *HERE.rglob("*.h")]:
            headers.write_for(file.read_text(encoding="utf-8"))
        headers.write_for(_PRECOMPILED)
        (folder / "all.hpp").write_text(_PRECOMPILED, encoding="utf-8")
        options = [*_FLAGS, "-I", str(HERE / "include"), "-I", str(include)]
        self.call([*options, "-x", "c++-header", str(folder / "all.hpp"), "-o", str(folder / "all.hpp.gch")])
        whole = folder / "whole.cpp"  # in one: it takes half the time
        sources = [file for file in sorted((HERE / "source").glob("*.cpp")) if file.stem != "main"]
        whole.write_text("".join(f'#include "{file}"\n' for file in sources), encoding="utf-8")
        objects = []
        for source in (whole, HERE / "source" / "main.cpp"):
            objects.append(str(folder / f"{source.stem}.o"))
            self.call([*options, "-include", str(folder / "all.hpp"), "-c", str(source), "-o", objects[-1]])
        subprocess.run(["ar", "rcs", str(folder / "librosward_double.a"), *objects], check=True)

    def call(self, arguments: Iterable[str]) -> None:
        """Call the compiler; what it complains of is in the exception."""
        done = subprocess.run([self._compiler, *arguments], capture_output=True, text=True, check=False)
        if done.returncode:
            raise CompileError(done.stderr)

    def compile(
        self, sources: Iterable[Path], program: Path, include: Iterable[Path] = (), define: Iterable[str] = ()
    ) -> Path:
        """Compile and link the sources of one program."""
        sources = list(sources)
        for source in sources:
            self._prepare(source.read_text(encoding="utf-8"))
        for folder in include:
            for header in folder.rglob("*.h*"):
                self._prepare(header.read_text(encoding="utf-8"))
        folders = [HERE / "include", self.folder / "include", *include]
        options = [
            *_FLAGS,
            *(f"-D{each}" for each in define),
            *(part for folder in folders for part in ("-I", str(folder))),
        ]
        given = ["-include", str(self.folder / "all.hpp"), *map(str, sources), str(self.folder / "librosward_double.a")]
        self.call([*options, *given, "-pthread", "-o", str(program)])
        return program

    def lacks(self, text: str, own: Container[str] = ()) -> str:
        """The first header of a library that a source includes and the double does not have; '' where there is none. `own` are of the program."""
        self._prepare(text)
        folders = (HERE / "include", self.folder / "include")
        missing = (
            n for n in _OF_A_LIBRARY.findall(text) if n not in own and not any((f / n).is_file() for f in folders)
        )
        return next(missing, "")

    def _prepare(self, text: str) -> None:
        self.headers.write_for(text)
        for path in _FORWARDED.findall(text):
            target = self.folder / "include" / path
            if not (HERE / "include" / path).exists() and not target.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(f'#pragma once\n#include "{_WHOLE[path.partition("/")[0]]}"\n', encoding="utf-8")


class CompileError(Exception):
    """The compiler refuses a program; the text is what it says."""


DOUBLE: Final = Double(COMPILER or "g++")


def run(program: Path, arguments: Iterable[str] = ()) -> Ran:
    """Run a compiled program."""
    done = _run(program, arguments)
    return read_log(done.stdout, done.returncode)


def _run(program: Path, arguments: Iterable[str] = ()) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False, timeout=_SECONDS)


def read_log(text: str, status: int) -> Ran:
    """What a program says that it created."""
    entities: list[Fact] = []
    system: list[Fact] = []
    for line in _LINE.findall(text):
        kind, node, *rest = line.split(" ")
        fact = (node, kind, *(rest[:2] or (node, "")))
        (system if rest[2:] else entities).append(fact)
    return Ran(entities, system, status, text)


def run_source(text: str, folder: Path, *, arguments: Iterable[str] = ()) -> Ran:
    """Compile and run a program of one file."""
    return run(_compile(text, folder), arguments)


def _compile(text: str, folder: Path) -> Path:
    source = folder / "main.cpp"
    source.write_text(text, encoding="utf-8")
    return DOUBLE.compile([source], folder / "program")


def fits_beside_others(text: str) -> bool:
    """Whether a program means the same in a namespace of its own."""
    return not _ALONE.search(text)


def run_many(texts: Iterable[str], folder: Path) -> list[Ran]:
    """Compile programs as one, which takes less time than one by one, and run each in a process of its own.

    Each is put into a namespace: its main body has to be `int main(int argc, char ** argv)`, and its macros are those of all that follow.
    """
    texts = list(texts)
    done = _run(compile_many(texts, folder))
    found = [read_log(text, int(status)) for text, status in PROGRAM.findall(done.stdout)]
    assert len(found) == len(texts), done.stdout
    return found


def compile_many(texts: Sequence[str], folder: Path) -> Path:
    """Compile programs as one, which runs each in a process of its own."""
    includes = dict.fromkeys(line.strip() for text in texts for line in _INCLUDE.findall(text))
    spaces = [f"namespace program{number} {{\n{_INCLUDE.sub('', text)}\n}}" for number, text in enumerate(texts)]
    mains = ", ".join(f"program{number}::main" for number in range(len(texts)))
    main = f"int main(int argc, char ** argv) {{ return rosward_double::run_many({{{mains}}}, argc, argv); }}"
    return _compile("\n".join([*includes, '#include "rosward_double/many.hpp"', *spaces, main]), folder)


def main() -> None:
    """`python -m cpp.compiled FILE.cpp …`, in the folder tests: what the program of these sources creates, as lines."""
    with tempfile.TemporaryDirectory() as folder:
        ran = run(DOUBLE.compile(map(Path, sys.argv[1:]), Path(folder) / "program"))
    for node, kind, name, type_ in ran.entities:
        print(f"{node}: {kind} {name} {type_}")
    print(f"exit status {ran.status}")


if __name__ == "__main__":
    main()
