# SPDX-License-Identifier: Apache-2.0
"""Does a survey give the same bits through a Dask cluster whose workers are killed as in one process after the other, and what does it cost?

python bench/survey.py ~/checkouts --workspaces 300 --output /tmp/survey

Each folder in CHECKOUTS is a repository; small workspaces are generated until there are `--workspaces` altogether. They are surveyed twice:
with `-j 1`, and by a local cluster of two workers. After a third of the repositories one worker is killed, after two thirds all are, and others join.
Exit status 1: a table differs, or a repository has no result.
"""

from __future__ import annotations

import argparse
import os
import resource
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Final

import pyarrow.parquet as pq
from distributed import Client, LocalCluster

import rosward

TABLES: Final = ("repositories", "nodes", "entities", "findings", "systems")
_TYPES: Final = ("String", "Bool", "Float64", "Int32")
_QOS: Final = ("10", "QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)", "qos_profile_sensor_data")


def generate(folder: Path, number: int) -> Path:
    """Write a small workspace: a package of a few nodes, some with parameters and loops, and a launch file. The same for the same number."""
    random = Random(number)
    workspace = folder / f"generated_{number:04}"
    package = workspace / "src" / f"robot_{number}"
    programs = {f"node_{n}": program(random, n) for n in range(random.randint(1, 5))}
    starts = [f"robot_{number} = robot_{number}.{name}:main" for name in programs]
    texts = {
        "package.xml": f"<package format='3'><name>robot_{number}</name><version>0.0.0</version><description>d</description>"
        "<maintainer email='a@b.c'>m</maintainer><license>Apache-2.0</license><exec_depend>rclpy</exec_depend>"
        "<export><build_type>ament_python</build_type></export></package>\n",
        "setup.py": f"from setuptools import setup\nsetup(name='robot_{number}', packages=['robot_{number}'], "
        f"entry_points={{'console_scripts': {starts!r}}})\n",
        f"robot_{number}/__init__.py": "",
        **{f"robot_{number}/{name}.py": text for name, text in programs.items()},
        "launch/all.launch.xml": "<launch>\n"
        + "".join(f"  <node pkg='robot_{number}' exec='{name}' namespace='robot'/>\n" for name in programs)
        + "</launch>\n",
    }
    for name, text in texts.items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists():  # written again it would be another state, and a bench that was stopped could not go on
            path.write_text(text, encoding="utf-8")
    return workspace


def program(random: Random, number: int) -> str:
    """One node: publishers in a loop, a subscription, and a topic whose name is a parameter, or unknown."""
    kind = random.choice(_TYPES)
    topic = random.choice(("self.get_parameter('topic').value", "'/shared'", "input()"))
    return f"""\
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from std_msgs.msg import {kind}


class Part(Node):
    def __init__(self):
        super().__init__('node_{number}')
        self.declare_parameter('topic', 'topic_{random.randint(0, 9)}')
        self.outputs = [self.create_publisher({kind}, f'out_{{n}}', {random.choice(_QOS)}) for n in range({random.randint(1, 8)})]
        self.create_subscription({kind}, {topic}, self.heard, {random.choice(_QOS)})

    def heard(self, message):
        for output in self.outputs:
            output.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Part())
"""


def through_dask(paths: list[Path], output: Path, progress: Callable[[str, int, int], None]) -> rosward.Survey:
    """The survey by a local cluster, workers of which are killed."""
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0", host="127.0.0.1", silence_logs=50
        ) as cluster,
        Client(cluster) as client,
    ):

        def kill(what: str, done: int, count: int) -> None:
            progress(what, done, count)
            if done in (count // 3, 2 * count // 3):
                victims = sorted(client.run(os.getpid).values())[: 1 if done == count // 3 else None]
                for victim in victims:
                    os.kill(victim, signal.SIGKILL)
                cluster.scale(3)
                print(f"\nafter {done} of {count}: killed {len(victims)} workers", flush=True)

        return rosward.survey(paths, output, executor=client.get_executor(pure=False), all_launch=True, progress=kill)


def show(what: str, done: int, count: int) -> None:
    """Progress."""
    if sys.stderr.isatty() or done % 20 == 0 or done == count:
        print(f"\r{what} {done}/{count}", end="", file=sys.stderr, flush=True)


def cost(output: Path) -> str:
    """What the processes of a survey took."""
    costs = pq.read_table(output / "costs.parquet").to_pydict()
    seconds, peaks = sorted(costs["cpu_seconds"]), [peak for peak in costs["peak_bytes"] if peak is not None]
    return (
        f"CPU {sum(seconds):.1f} s, median {seconds[len(seconds) // 2]:.2f} s, largest {seconds[-1]:.1f} s; "
        f"largest peak {max(peaks) / 2**20:.0f} MB"
    )


def main() -> int:
    """Survey twice and compare."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkouts", type=Path)
    parser.add_argument("--workspaces", type=int, default=300)
    parser.add_argument("--output", type=Path, required=True)
    options = parser.parse_args()
    paths = sorted(path for path in options.checkouts.iterdir() if path.is_dir())[: options.workspaces]
    paths += [generate(options.output / "generated", number) for number in range(options.workspaces - len(paths))]
    before = resource.getrusage(resource.RUSAGE_SELF)
    dask = through_dask(paths, options.output / "dask", show)
    after = resource.getrusage(resource.RUSAGE_SELF)
    own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"\ndask: {dict(dask.states)}, {cost(options.output / 'dask')}; the process that asks: {own:.1f} s")
    one = rosward.survey(paths, options.output / "one", jobs=1, all_launch=True, progress=show)
    print(f"\none:  {dict(one.states)}, {cost(options.output / 'one')}")
    differing = [
        name
        for name in TABLES
        if (options.output / "dask" / f"{name}.parquet").read_bytes()
        != (options.output / "one" / f"{name}.parquet").read_bytes()
    ]
    print(
        f"rows {dict(one.rows)}; {'DIFFERENT: ' + ', '.join(differing) if differing else 'the same bits in all tables'}"
    )
    return 1 if differing or not (one.complete and dask.complete) else 0


if __name__ == "__main__":
    sys.exit(main())
