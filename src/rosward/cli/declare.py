# SPDX-License-Identifier: Apache-2.0
"""`rosward declare PKG/EXE`: begin the declaration of a program that is not analysed, in a file that the next run reads."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from rosward.cli.shared import WrongUseError, with_exit_status
from rosward.cli.status import COMPLETE
from rosward.safe import printable

if TYPE_CHECKING:
    from rosward.declaring.sketch import Sketch

_PACKAGE: Final = re.compile(r"[A-Za-z0-9_-]{1,200}")
_ENDINGS: Final = (".py", ".cpp", ".cc", ".cxx", ".c", ".hpp", ".hh", ".hxx", ".h", ".ipp")
_MOST_FILES: Final = 500


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = (
        "Write DIR/nodes/PKG.yaml, or add to it, with what PKG/EXE creates: from a running robot, from a search of its source, "
        "or as a skeleton to fill in. Review the file, delete the line `open`, and pass the folder with --models DIR. Nothing is executed."
    )
    parser.epilog = "Exit status: 0 written; 2 usage error, or already declared."
    parser.set_defaults(run=with_exit_status(_run))
    parser.add_argument("program", metavar="PKG/EXE", help="the executable, or PKG/namespace::Class for a component")
    parser.add_argument(
        "--from",
        dest="origins",
        action="append",
        default=[],
        metavar="FILE",
        help="output file of `rosward snapshot`, output of `ros2 node info`, or C++ or Python source (file or folder); may be repeated",
    )
    parser.add_argument("--node", metavar="NAME", help="full name of this node on the running robot")
    parser.add_argument(
        "-o",
        "--output",
        metavar="DIR",
        default="models",
        help="folder of declarations (default: models); - prints the declaration",
    )


def _run(options: argparse.Namespace) -> int:
    from rosward.declaring.sketch import together
    from rosward.declaring.write import declaration, with_declaration

    package, slash, program = options.program.partition("/")
    if not slash or not _PACKAGE.fullmatch(package) or not program or "/" in program or not program.isprintable():
        raise WrongUseError(f"{options.program!r} is not of the form PKG/EXE")
    sketch = together([_sketch(Path(origin), program, options.node) for origin in options.origins])
    text = declaration(package, program, sketch)
    if options.output == "-":
        sys.stdout.write(text)
        return COMPLETE
    file = Path(options.output) / "nodes" / f"{package}.yaml"
    before = _before(file, package, program)
    text = text if before is None else with_declaration(before, program, sketch)
    _check(text, package, program, file)
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    except OSError as error:
        raise WrongUseError(f"cannot write {file}: {error.strerror or error}") from error
    for line in _next_steps(options.program, sketch, file, options.output):
        print(printable(line))  # noqa: T201
    return COMPLETE


def _next_steps(program: str, sketch: Sketch, file: Path, folder: str) -> Iterable[str]:
    number = len(sketch.entities)
    yield f"{file}: {program} with {number} endpoint{'' if number == 1 else 's'}"
    yield from (f"  {text}" for text in sketch.told[:12])
    if len(sketch.told) > 12:
        yield f"  … and {len(sketch.told) - 12} more remarks in the file"
    yield "Review the file, delete the line `open` when it is complete, and analyse again with"
    yield f"  --models {folder}"


def _before(file: Path, package: str, program: str) -> str | None:
    """The text of the file that is there. Raises WrongUseError where it cannot be added to."""
    from rosward.deployment.declared.read import read_package

    if not os.path.lexists(file):
        return None
    text = _text(file)
    found, findings = read_package(text, str(file), package)
    if found is None:
        raise WrongUseError("; ".join(f"{f.place}: {f.message}" for f in findings))
    if program in found.executables or program in found.components:
        raise WrongUseError(f"{file} declares {package}/{program} already; use -o - to print what would be written")
    return text


def _check(text: str, package: str, program: str, file: Path) -> None:
    """Never leave a file behind that the next run refuses."""
    from rosward.deployment.declared.read import read_package

    found, findings = read_package(text, str(file), package)
    if found is None or program not in {**found.executables, **found.components}:
        why = "; ".join(f.message for f in findings) or "its list of programs has a form that cannot be extended"
        raise WrongUseError(f"{file}: {why} (use -o - to print what to add)")


def _sketch(origin: Path, program: str, node: str | None) -> Sketch:
    """What a file, or a folder of source, says of a program."""
    from rosward.audit.document import read_snapshot
    from rosward.audit.node_info import read_node_info
    from rosward.declaring.running import NotRunningError, node_of, sketch_of
    from rosward.declaring.source import sketch_of_source
    from rosward.source.json_fields import UnreadableError

    if origin.is_dir() or origin.suffix in _ENDINGS:
        return sketch_of_source(_source(origin))
    text = _text(origin)
    try:
        graph = read_snapshot(str(origin)) if text.lstrip().startswith("{") else read_node_info({str(origin): text})
        return sketch_of(node_of(graph, program, node), origin.name)
    except (UnreadableError, NotRunningError) as error:
        raise WrongUseError(f"--from {origin}: {error}") from error


def _source(origin: Path) -> dict[str, str]:
    if not origin.is_dir():
        return {origin.name: _text(origin)}
    files: list[str] = []
    for above, inner, names in os.walk(origin):
        inner[:] = sorted(each for each in inner if not each.startswith(".") and each not in ("test", "tests", "build"))
        files += (os.path.join(above, name) for name in sorted(names) if name.endswith(_ENDINGS))  # noqa: PTH118
    if not files:
        raise WrongUseError(f"--from {origin}: it contains no C++ or Python source")
    if len(files) > _MOST_FILES:
        raise WrongUseError(f"--from {origin}: more than {_MOST_FILES} files; pass only those of the program")
    return {Path(file).relative_to(origin).as_posix(): _text(Path(file)) for file in files}


def _text(file: Path) -> str:
    from rosward.findings import Finding
    from rosward.source import limits
    from rosward.source.text import read_bytes

    data = read_bytes(file, str(file), limits.SEARCHED_FILE)
    if isinstance(data, Finding):
        raise WrongUseError(f"{file}: {data.message}")
    return data.decode("utf-8", "replace")
