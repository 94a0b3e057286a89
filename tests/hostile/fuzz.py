# SPDX-License-Identifier: Apache-2.0
"""Does the whole way hold for files that nobody meant to write? Batches of changed files, each through readers, engine and outputs.

    python -m hostile.fuzz --count 20000 --seed 7        (in the folder tests)

A batch is a workspace of packages, each with one file that was changed, beside a sound package. What must hold: nothing raises, the sound
node is found with its topic, whatever is written can be read again, and the time is bounded. A batch that fails is kept, file by file.
"""

from __future__ import annotations

import argparse
import json
import shutil
import tempfile
import time
import traceback
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Final, NamedTuple
from xml.etree import ElementTree

import rosward
from hostile.mutations import Seed, change, seeds
from rosward.analysis.launched import launched
from rosward.deployment.request import Request
from rosward.engine.budget import Budget
from rosward.outputs.documents.launch_tree_json import launch_tree_json
from rosward.outputs.files import write_outputs
from rosward.outputs.policies.nodl import nodl_document
from rosward.outputs.terminal.launch_tree import launch_tree_text
from rosward.outputs.writing import Material

SMALL: Final = Budget(steps=20_000, entry_steps=4_000, net=False)
FORMATS: Final = ("json", "policy", "dot", "html", "permissions")
ROBOT: Final = "examples/delivery_robot/"

GOOD: Final = """\
import rclpy
from std_msgs.msg import String

rclpy.init()
good = rclpy.create_node('good')
good.create_publisher(String, 'chatter', 10)
rclpy.spin(good)
"""
GOOD_LAUNCH: Final = """\
<launch><node pkg="good" exec="good.py"/></launch>
"""
GOOD_CMAKE: Final = "project(good)\ninstall(PROGRAMS good.py DESTINATION lib/good)\n"
GOOD_MANIFEST: Final = """\
<package format="3"><name>good</name><version>1.0.0</version><description>Good</description>
<maintainer email="a@b.cd">A</maintainer><license>Apache-2.0</license><export><build_type>ament_cmake</build_type></export></package>
"""


class Changed(NamedTuple):
    """A file after its change, and where it stands in the workspace of the batch."""

    seed: str
    path: str
    text: bytes


class Broken(AssertionError):  # noqa: N818
    """What must hold does not."""


def changed_files(random: Random, known: list[Seed]) -> Iterator[Changed]:
    """Files without end, one after the other; each kind of file comes as often as the others, not each file."""
    kinds: dict[str, list[Seed]] = {}
    for seed in known:
        name = seed.name
        launch = "launch" if "/launch/" in name else name.partition("/")[0]
        kinds.setdefault(f"{launch}.{name.rpartition('.')[2]}", []).append(seed)
    order = [*kinds, *(kind for kind in kinds if kind.endswith(".py"))] * 1
    number = 0
    while True:
        kind = random.choice(order)
        seed = random.choice(kinds[kind])
        text = change(random, seed, kinds[kind])
        yield Changed(seed.name, _stands(seed, number), text)
        number += 1


def _stands(seed: Seed, number: int) -> str:
    """Programs in a package of their own; files of the example in a copy of their package; models in the folder of models."""
    name = seed.name
    if name.startswith("program/"):
        return f"ws/p{number}/{name.partition('/')[2].partition('/')[2]}"
    if name.startswith(ROBOT):
        package, _, inner = name[len(ROBOT) :].partition("/")
        return f"ws/r{number}/{package}/{inner}"
    return f"models/{'nodes/' if name.endswith('.yaml') else ''}{Path(name).name}"


def write_good(workspace: Path) -> None:
    """The sound package that must be found whatever stands beside it."""
    for path, text in (
        ("good.py", GOOD),
        ("good.launch.xml", GOOD_LAUNCH),
        ("CMakeLists.txt", GOOD_CMAKE),
        ("package.xml", GOOD_MANIFEST),
    ):
        _write(workspace / "good" / path, text.encode())


def write_batch(folder: Path, batch: list[Changed]) -> None:
    """The workspace of a batch."""
    write_good(folder / "ws")
    (folder / "models" / "nodes").mkdir(parents=True, exist_ok=True)
    for each in batch:
        if each.seed.startswith(ROBOT):
            package = each.seed[len(ROBOT) :].partition("/")[0]
            copy, whole = (
                folder / each.path.partition(package)[0] / package,
                Path(__file__).parents[2] / ROBOT / package,
            )
            if whole.is_dir():  # a file of the workspace itself is of no package
                shutil.copytree(whole, copy, ignore=_large)
        _write(folder / each.path, each.text)


def _large(_: str, names: list[str]) -> list[str]:
    return [n for n in names if n in ("resource", "__pycache__")]


def _write(path: Path, text: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(text)


def check_batch(folder: Path, batch: list[Changed]) -> None:
    """Run the whole way over a batch. Raises whatever goes wrong."""
    write_batch(folder, batch)
    workspace, models = folder / "ws", [folder / "models"]
    params = tuple(str(folder / c.path) for c in batch if "/config/" in c.path)
    for name, request in (("run", Request(params=params)), ("launch", Request(all_launch=True, params=params))):
        result = rosward.extract(workspace, models=models, budget=SMALL, request=request)
        good = [n for n in result.network.nodes if n.fqn == "/good"]
        if not any(e.name == "/chatter" and e.kind is rosward.EntityKind.PUBLISHER for n in good for e in n.entities):
            raise Broken(f"{name}: the sound node is lost")
        out = folder / "out" / name
        write_outputs(Material(result.network, "wildcard"), str(out), FORMATS, net=False)
        _check_outputs(out)
        for node in result.network.nodes:
            nodl_document(node)
    systems, findings = launched(workspace, models=models, budget=SMALL, request=Request(all_launch=True))
    json.loads(launch_tree_json(systems, findings))
    text = launch_tree_text(systems, findings)
    if any(not c.isprintable() and c not in "\n\xa0\xad" for c in text if ord(c) < 0xA0):
        raise Broken("the text of the launch tree holds control characters")
    if {p.name for p in folder.iterdir()} != {"ws", "models", "out"}:
        raise Broken(f"something was written beside the outputs: {sorted(folder.iterdir())}")


def _check_outputs(out: Path) -> None:
    for path in out.rglob("*"):
        if path.suffix == ".xml":
            ElementTree.parse(path)
        elif path.suffix == ".json":
            json.loads(path.read_bytes())
        elif path.is_file():
            text = path.read_text(encoding="utf-8")
            if "\0" in text or "\x1b" in text:
                raise Broken(f"{path.name} holds control characters")


class Failure(NamedTuple):
    """What one changed file did."""

    changed: Changed
    error: str
    seconds: float


def fuzz(count: int, seed: int, size: int = 25, slow: float = 20.0) -> list[Failure]:
    """Check `count` changed files in batches; the failures, down to single files. `slow`: seconds that one file may take."""
    random = Random(seed)
    files = changed_files(random, seeds())
    failures: list[Failure] = []
    done = 0
    while done < count:
        batch = [next(files) for _ in range(min(size, count - done))]
        done += len(batch)
        failures += _failures(batch, slow)
    return failures


def _failures(batch: list[Changed], slow: float) -> list[Failure]:
    error, seconds = attempt(batch)
    if not error and seconds <= slow:
        return []
    if len(batch) == 1:
        return [Failure(batch[0], error or f"{seconds:.1f} seconds", seconds)]
    half = len(batch) // 2
    found = _failures(batch[:half], slow) + _failures(batch[half:], slow)
    if found or not error:
        return found
    return [Failure(batch[0], f"only together: {[c.path for c in batch]}\n{error}", seconds)]


def attempt(batch: list[Changed]) -> tuple[str, float]:
    """What went wrong, and how long it took."""
    with tempfile.TemporaryDirectory(prefix="rosward-fuzz-") as folder:
        start = time.process_time()
        try:
            check_batch(Path(folder), batch)
        except Exception:
            return traceback.format_exc(limit=-8), time.process_time() - start
        return "", time.process_time() - start


def _main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=1_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--size", type=int, default=25, help="files in a batch")
    parser.add_argument("--keep", type=Path, default=Path("fuzz-failures"), help="where failing files go")
    options = parser.parse_args()
    start = time.monotonic()
    failed = 0
    for first in range(0, options.count, 500):
        for number, failure in enumerate(fuzz(min(500, options.count - first), options.seed + first, options.size)):
            failed += 1
            kept = options.keep / f"{options.seed + first}-{number}" / failure.changed.path
            _write(kept, failure.changed.text)
            (kept.parent / "error.txt").write_text(f"{failure.changed.seed}\n{failure.error}")
            print(kept, failure.error.strip().splitlines()[-1][:200], flush=True)
        print(
            f"{min(first + 500, options.count)} files, {failed} failures, {time.monotonic() - start:.0f} s", flush=True
        )


if __name__ == "__main__":
    _main()
