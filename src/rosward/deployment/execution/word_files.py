# SPDX-License-Identifier: Apache-2.0
"""Which parameter files does a command line name in its own words, beside those of `parameters=[…]`, and what do they hold?

arguments=['--ros-args', '--params-file', '$(find-pkg-share demo)/a.yaml']    ->    the content of that file, under the word as it is printed

rcl opens them, not launch: where one is not there, the program ends when it starts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

from rosward.deployment.execution.perform_paths import normal_path
from rosward.deployment.execution.yaml_values import plain_text
from rosward.domain.choice import options, reasons_of
from rosward.domain.text import readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Value
from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Scene
    from rosward.effects.configuration import Given
    from rosward.location import Place

_FILE: Final = "--params-file"


class WordFiles(NamedTuple):
    """What the named files hold, by the words that name them, and why the content of some is not known."""

    files: dict[str, tuple[Given, ...] | None]
    missing: dict[str, Reason]


def word_files(words: Sequence[Value], scene: Scene, place: Place) -> WordFiles:
    """The parameter files that a command line names."""
    found = WordFiles({}, {})
    for path in _paths(words):
        for option in options(path):
            _look(option, found, scene, place)
    return found


def _look(path: Value, found: WordFiles, scene: Scene, place: Place) -> None:
    word, normal = readable(path), normal_path(path)
    content = scene.generated.content(normal, place)
    if content.absent:
        shown = scene.files.show(normal)
        scene.findings.tell(
            "RW315", f"The parameter file {shown} does not exist: the program ends when it starts.", place
        )
    found.files[word] = () if content.absent else content.rows
    if content.rows is None and not content.absent:
        reasons = reasons_of(path)
        found.missing[word] = content.reason or (reasons[0] if reasons else Reason(Cause.FILE, word, place))


def _paths(words: Sequence[Value]) -> Iterator[Value]:
    """What stands behind `--params-file` where words are for ROS: between `--ros-args` and `--`."""
    for_ros, before = False, None
    for word in words:
        if for_ros and before == _FILE:
            before = None
            yield word
            continue
        before = plain_text(word) if len(options(word)) == 1 else None
        for_ros = before != "--" if for_ros else before == "--ros-args"
