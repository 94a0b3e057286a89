# SPDX-License-Identifier: Apache-2.0
"""The graph as a picture, drawn by `graphviz-pure`: a Graphviz in one program, with its own fonts, the same on every
machine. Where it is not installed (rosdep has no key for it) the `dot` of the system draws, with the fonts that are there.

A graph that would be larger than a large screen shows (see `_WIDEST`) is drawn from further away: nodes without topics,
then namespaces (`dot_summary.py`). Where that is too large as well, or a renderer is missing or fails, the picture says so in
words, with the numbers and where to look instead. The limits are sizes and not times, so that the same sources give the
same bytes everywhere; the time limit is only there for a machine in trouble: 300 shapes take less than a second.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Final

from rosward.network.graph import Network
from rosward.outputs.graphs.dot import drawing
from rosward.outputs.graphs.dot_language import UNKNOWN, Drawing
from rosward.outputs.graphs.dot_summary import summaries
from rosward.outputs.pictures import Pictures
from rosward.outputs.writing import File, Material
from rosward.safe import xml_text
from rosward.source import disk

__all__ = ["files", "graph_svg"]

_PROGRAM: Final = "graphviz-pure"
_INSTEAD: Final = "dot"
_ENDINGS: Final = (".exe", "") if os.name == "nt" else ("",)
_MOST_VERTICES: Final = 300
_MOST_STEPS: Final = 4000
"""Layers that edges cross: above them drawing takes long, and shows a black spot."""

_WIDEST: Final = 2600
_HIGHEST: Final = 1700
"""Points: at these a letter is still read when the picture is as wide as a screen."""

_SECONDS: Final = 600
_SIZE: Final = re.compile(r'<svg width="(?P<width>[\d.]+)pt" height="(?P<height>[\d.]+)pt"')
_HATCHED: Final = '<ellipse fill="url(#unknown-interface)"'
_HATCH: Final = (
    '<defs><pattern id="unknown-interface" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">'
    '<rect width="7" height="7" fill="#f4f4f1"/><rect width="2" height="7" fill="#dcdcd6"/></pattern></defs>'
)
_PROLOGUE: Final = re.compile(r"\A.*?(?=<svg\b)", re.DOTALL)


def files(material: Material) -> Iterator[File]:
    """The files of the format `svg`."""
    yield "graph.svg", graph_svg(material.network, material.system, material.types, pictures=material.pictures)


def graph_svg(
    network: Network,
    system: bool = False,
    types: bool = False,
    *,
    links: bool = False,
    pictures: Pictures | None = None,
) -> str:
    """The graph as SVG. `links` makes each node a link to `#node-N`, its number in the network; `pictures` are those of before."""
    known = pictures or Pictures()
    whole = drawing(network, system, types, links)
    too_large: set[str] = set()
    for drawn in chain((whole,), summaries(network, system)):
        if drawn.vertices <= _MOST_VERTICES and drawn.steps <= _MOST_STEPS and drawn.shapes not in too_large:
            picture = known.of(drawn.text, partial(_picture, drawn, known))
            if _fits(picture):
                return picture
            too_large.add(drawn.shapes)
    return _message("This graph is too large to draw", whole)


def _fits(picture: str) -> bool:
    size = _SIZE.search(picture)
    return size is None or (float(size["width"]) <= _WIDEST and float(size["height"]) <= _HIGHEST)


def _picture(drawn: Drawing, known: Pictures) -> str:
    program = _program()
    if program is None:
        return _message(f"{_PROGRAM} is not installed, so there is no drawing", drawn)
    told: list[str] = []
    state = disk.note_program(program)
    picture = known.by_program(f"{program}\0{state}", drawn.text, partial(_drawn_by, program, drawn, told))
    return _message(told[0], drawn) if picture is None else picture


def _drawn_by(program: str, drawn: Drawing, told: list[str]) -> str | None:
    """The drawing; of one that is too large, the beginning alone. None where it is not drawn, and `told` is why."""
    try:
        done = subprocess.run(
            [program, "-Kdot", "-Tsvg"], input=drawn.text.encode(), capture_output=True, timeout=_SECONDS, check=True
        )
    except subprocess.TimeoutExpired:
        disk.tear()  # another time it may be quicker
        told.append(f"Drawing took more than {_SECONDS} seconds")
        return None
    except (OSError, subprocess.CalledProcessError):
        disk.tear()
        told.append(f"{_PROGRAM} could not draw this graph")
        return None
    svg = _PROLOGUE.sub("", done.stdout.decode(errors="replace"))
    if not svg.startswith("<svg"):
        told.append(f"{_PROGRAM} could not draw this graph")
        return None
    return _hatched(svg) if _fits(svg) else f"{svg.partition('>')[0]}/>"


def _hatched(svg: str) -> str:
    """The drawing with nodes of unknown interface hatched: a fill that Graphviz does not have."""
    plain = f'<ellipse fill="{UNKNOWN.fill}"'
    if plain not in svg:
        return svg
    head, end, body = svg.partition(">")
    return f"{head}{end}\n{_HATCH}{body.replace(plain, _HATCHED)}"


def _program() -> str | None:
    """The program beside the running Python, which is the version that was asked for, or that of the search path; else Graphviz.

    Never one of the current folder: that may be the folder that is analysed.
    """
    beside = (str(Path(sys.executable).parent), sysconfig.get_path("scripts"))
    return _path_of(_PROGRAM, beside) or _path_of(_INSTEAD)


def _path_of(name: str, folders: Iterable[str] = ()) -> str | None:
    here = Path.cwd()
    for folder in (*folders, *os.environ.get("PATH", "").split(os.pathsep)):
        for ending in _ENDINGS:
            program = Path(folder) / f"{name}{ending}"
            if (
                Path(folder).is_absolute()
                and Path(folder) != here
                and disk.is_file(program)
                and disk.is_executable(program)
            ):
                return str(program)
    return None


def _message(reason: str, drawn: Drawing) -> str:
    lines = [
        reason + ".",
        f"It has {drawn.vertices} nodes, topics, services and actions, and {drawn.edges} edges.",
        "graph.dot has the complete graph; network.json and the tables of the report have the same content as text.",
    ]
    texts = "".join(f'<text x="20" y="{40 + 24 * number}">{xml_text(line)}</text>' for number, line in enumerate(lines))
    return (
        '<svg width="720pt" height="110pt" viewBox="0 0 720 110" xmlns="http://www.w3.org/2000/svg">'
        '<rect width="720" height="110" fill="white"/>'
        f'<g font-family="Arial, sans-serif" font-size="14" fill="#1a1a1a">{texts}</g></svg>\n'
    )
