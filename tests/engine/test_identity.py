# SPDX-License-Identifier: Apache-2.0
"""What a run says of the program means the same after a reload, and in another process: code and operations are told by stable keys."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from rosward.analysis.attempts import run
from rosward.analysis.process import Run
from rosward.analysis.read import read_sources
from rosward.analysis.seen import seen_of
from rosward.analysis.unreached import unreached
from rosward.models.ros.facts import OWN
from rosward.ros.distro import Distro

PROGRAM = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

def names(prefix):
    for kind in ('scan', 'image'):
        yield f'{prefix}/{kind}'
    yield from ('status', 'battery')

class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.made = [self.create_publisher(String, name, 10) for name in names('front')]
        self.create_subscription(String, 'command', self.on_command, 10)
        if False:
            self.create_publisher(String, 'never', 10)

    def on_command(self, message):
        self.reply = self.create_publisher(String, 'reply', 10)

    def later(self):
        self.create_publisher(String, 'late', 10)

def main():
    rclpy.init()
    rclpy.spin(Driver())

if __name__ == '__main__':
    main()
"""

CHILD = """
import pickle, sys
from pathlib import Path
from test_identity import runs
sys.stdout.buffer.write(pickle.dumps(runs(Path(sys.argv[1]))[0]))
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "driver.py").write_text(PROGRAM, encoding="utf-8")
    return tmp_path


def runs(folder: Path) -> list[Run]:
    read = read_sources([folder], Distro.JAZZY)
    return [run(read.library, entry, read.budget) for entry in read.plan.entries]


def facts(found: Run) -> tuple[object, ...]:
    """What is said of the program, in an order of its own."""
    entities = sorted(str(e.place) for e in found.log.entities)
    return (
        found.entry,
        sorted(found.entered),
        sorted(found.reached),
        sorted(found.instantiated),
        sorted(found.asked),
        sorted(found.log.functions),
        entities,
    )


def test_a_text_that_is_lowered_twice_gives_the_same_facts(folder: Path) -> None:
    first, second = runs(folder), runs(folder)
    assert [facts(r) for r in first] == [facts(r) for r in second]
    assert len(first[0].log.entities) == 6


@pytest.mark.parametrize("seed", ["1", "2"])
def test_a_run_of_another_process_says_the_same_here(folder: Path, seed: str) -> None:
    """Under another seed of hashes, at other addresses of memory: it is sent, and held against the sources as they are read here."""
    tests = Path(__file__).parent
    environment = {"PYTHONHASHSEED": seed, "PYTHONPATH": f"{tests.parent.parent / 'src'}:{tests}"}
    command = [sys.executable, "-c", CHILD, str(folder)]
    done = subprocess.run(command, capture_output=True, check=True, timeout=300, env=environment)
    sent = pickle.loads(done.stdout)
    read = read_sources([folder], Distro.JAZZY)
    module = read.sources.module("driver.py")
    assert module is not None
    here = run(read.library, read.plan.entries[0], read.budget)
    assert facts(sent) == facts(here)
    told = unreached([seen_of(sent, read.library)], [module], OWN)
    assert told == unreached([seen_of(here, read.library)], [module], OWN)
    assert [(f.code, f.place.line) for f in told] == [("RW205", 17), ("RW205", 23)]
