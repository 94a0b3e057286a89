# SPDX-License-Identifier: Apache-2.0
"""How does the time grow with the program? Programs of 10, 100, 1,000 and 4,000 of each kind are written and analysed.

    python bench/growth.py [KIND...] [--sizes 10,100,1000,4000] [--most 1.35]

Prints CPU seconds, the ratio of the last two sizes, memory, and the exponent between them (1: in proportion; n log n is 1.1 to 1.2). What every
run costs before it reads anything is taken off. Exit status 1 where an exponent is above `--most`, or a run fails.
"""

from __future__ import annotations

import argparse
import math
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from measure import measure

_SECONDS: Final = 600.0
_HEAD: Final = (
    "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\nfrom std_srvs.srv import Empty\n"
)
_PACKAGE: Final = "<package format='3'><name>p</name><version>0.0.0</version><description/><maintainer email='a@b.c'/><license/></package>\n"
_LAUNCH: Final = "<launch>\n{}\n</launch>\n"

Files = dict[str, str]


def _node(lines: Sequence[str], rest: str = "") -> Files:
    """One program with one node, whose constructor holds these lines."""
    body = "".join(f"        {line}\n" for line in lines)
    text = f"{_HEAD}class N(Node):\n    def __init__(self):\n        super().__init__('n')\n{body}{rest}"
    return {
        "n.py": f"{text}def main():\n    rclpy.init()\n    rclpy.spin(N())\nif __name__ == '__main__':\n    main()\n"
    }


def _main(lines: Sequence[str], before: str = "") -> Files:
    """One program whose main function holds these lines."""
    body = "".join(f"    {line}\n" for line in lines)
    return {"m.py": f"{_HEAD}{before}def main():\n    rclpy.init()\n{body}if __name__ == '__main__':\n    main()\n"}


def _callbacks(n: int) -> Files:
    lines = [f"self.create_subscription(String, 's{i}', self.on{i}, 1)" for i in range(n)]
    return _node(lines, "".join(f"    def on{i}(self, m):\n        self.last{i} = m.data\n" for i in range(n)))


def _class_chain(n: int) -> Files:
    classes = "".join(f"class C{i}({f'C{i - 1}' if i else 'Node'}):\n    a{i} = {i}\n" for i in range(n))
    return _main([f"rclpy.spin(C{n - 1}('n'))"], classes)


def _call_chain(n: int) -> Files:
    functions = "".join(f"def f{i}(x):\n    return {f'f{i - 1}(x)' if i % 40 else 'x'}\n" for i in range(n))
    return _main([f"Node('n').create_publisher(String, f{i}('t'), 1)" for i in range(39, n, 40)], functions)


def _includes(n: int) -> Files:
    files = {f"launch/l{i}.launch.xml": _LAUNCH.format("<arg name='a' default='b'/>") for i in range(n)}
    lines = "\n".join(f"<include file='$(dirname)/l{i}.launch.xml'/>" for i in range(n))
    return {"package.xml": _PACKAGE, **files, "launch/top.launch.xml": _LAUNCH.format(lines), "n.py": "x = 1\n"}


def _launched(n: int) -> Files:
    lines = "\n".join(f"<node pkg='p' exec='e' name='n{i}'><remap from='a' to='b{i}'/></node>" for i in range(n))
    return {"package.xml": _PACKAGE, "launch/top.launch.xml": _LAUNCH.format(lines), "n.py": "x = 1\n"}


def _launch_files(n: int) -> Files:
    files = {f"launch/l{i}.launch.xml": _LAUNCH.format(f"<node pkg='p' exec='e' name='n{i}'/>") for i in range(n)}
    return {"package.xml": _PACKAGE, **files, "n.py": "x = 1\n"}


def _processes(n: int) -> Files:
    return {f"n{i}.py": f"{_HEAD}rclpy.init()\nNode('n{i}').create_publisher(String, 't', 1)\n" for i in range(n)}


def _remaps(n: int) -> Files:
    rules = ", ".join(f"'-r', 'a{i}:=b{i}'" for i in range(n))
    return _main([f"n = Node('n', cli_args=['--ros-args', {rules}])", "n.create_publisher(String, 'a0', 1)"])


KINDS: Final[dict[str, tuple[Callable[[int], Files], tuple[str, ...]]]] = {
    "publishers": (lambda n: _node([f"self.create_publisher(String, 't{i}', 1)" for i in range(n)]), ()),
    "timers": (
        lambda n: _node(
            [f"self.create_timer({i + 1}, self.tick)" for i in range(n)], "    def tick(self):\n        self.n = 1\n"
        ),
        (),
    ),
    "timers, each its own": (
        lambda n: _node(
            [f"self.create_timer(1.0, self.t{i})" for i in range(n)],
            "".join(f"    def t{i}(self):\n        self.n{i} = {i}\n" for i in range(n)),
        ),
        (),
    ),
    "subscriptions": (_callbacks, ()),
    "nodes in one process": (lambda n: _main([f"n{i} = Node('n{i}')" for i in range(n)]), ()),
    "processes": (_processes, ()),
    "parameters": (lambda n: _node([f"self.declare_parameter('p{i}', {i})" for i in range(n)]), ()),
    "remaps": (_remaps, ()),
    "class chain": (_class_chain, ()),
    "methods": (
        lambda n: _node(
            [f"self.m{i}()" for i in range(n)],
            "".join(f"    def m{i}(self):\n        self.a{i} = 1\n" for i in range(n)),
        ),
        (),
    ),
    "functions that call each other": (_call_chain, ()),
    "branches": (lambda n: _main([f"if input():\n        x{i} = {i}" for i in range(n)] + ["Node('n')"]), ()),
    "findings": (lambda n: _node([f"self.create_publisher(String, input(), {i})" for i in range(n)]), ()),
    "includes": (_includes, ("--launch", "launch/top.launch.xml")),
    "nodes of a launch file": (_launched, ("--launch", "launch/top.launch.xml")),
    "launch files": (_launch_files, ("--all-launch",)),
}
"""What grows: the program, and the options of the command."""


def main() -> int:
    """Measure each kind that is asked for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=f"some of: {', '.join(KINDS)}")
    parser.add_argument("--sizes", default="10,100,1000,4000")
    parser.add_argument("--most", type=float, default=1.35, help="the greatest exponent that is well")
    options = parser.parse_args()
    sizes = [int(size) for size in options.sizes.split(",")]
    failed = False
    start = _cost({"n.py": "x = 1\n"}, ())[0] or 0.0
    print(f"{'':32}" + "".join(f"{size:>9}" for size in sizes) + "    ratio  exponent       MB")
    for kind in options.kinds or KINDS:
        make, arguments = KINDS[kind]
        costs = [_cost(make(size), arguments) for size in sizes]
        seconds = [None if cpu is None else max(cpu - start, 0.01) for cpu, _ in costs]
        cells = "".join(f"{'failed' if cpu is None else f'{cpu:.2f}':>9}" for cpu in seconds)
        before, last = seconds[-2], seconds[-1]
        if before is None or last is None:
            failed = True
            print(f"{kind:32}{cells}", flush=True)
            continue
        exponent = math.log(last / before) / math.log(sizes[-1] / sizes[-2])
        failed = failed or (exponent > options.most and last > 1)
        print(f"{kind:32}{cells}{last / before:9.1f}{exponent:10.2f}{costs[-1][1]:9.0f}", flush=True)
    return 1 if failed else 0


def _cost(files: Files, arguments: Sequence[str]) -> tuple[float | None, float]:
    """CPU seconds (None: it failed) and MB of one analysis."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "source")
        for name, text in files.items():
            source.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
            source.joinpath(name).write_text(text, encoding="utf-8")
        where = [str(source / a) if "/" in a else a for a in arguments]
        command = [
            sys.executable,
            "-m",
            "rosward",
            "extract",
            str(source),
            "-q",
            "-o",
            str(Path(folder, "out")),
            *where,
        ]
        run = measure(command, seconds=_SECONDS)
    return (run.cpu if run.status in (0, 1) else None), run.peak_mb


if __name__ == "__main__":
    sys.exit(main())
