# SPDX-License-Identifier: Apache-2.0
"""How does the time grow with the program? Programs of 10, 100, 1,000 and 4,000 of each kind are written and analysed.

    python bench/growth.py [KIND...] [--sizes 10,100,1000,4000] [--most 1.25]

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
from typing import Final, NamedTuple

from measure import measure

_SECONDS: Final = 600.0
_QUICK: Final = 3.0
_LEAST: Final = 0.2
"""Less is not told from what every run costs."""
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


def _files(n: int) -> Files:
    return {f"f{i}.py": "import rclpy\nx = 1\n" for i in range(n)} | _main(["Node('n')"])


def _imports(n: int) -> Files:
    files = {f"f{i}.py": f"import rclpy\nfrom f{i - 1} import x\n" if i % 40 else "x = 't'\n" for i in range(n)}
    lines = [f"Node('n').create_publisher(String, f{i}.x, 1)" for i in range(39, n, 40)]
    return files | _main(lines, "".join(f"import f{i}\n" for i in range(39, n, 40)))


def _packages(n: int) -> Files:
    files: Files = {}
    for i in range(n):
        name = f"p{i}"
        files[f"{name}/package.xml"] = _PACKAGE.replace("<name>p<", f"<name>{name}<")
        files[f"{name}/setup.py"] = (
            f"from setuptools import setup\nsetup(name='{name}', packages=['{name}'], "
            f"entry_points={{'console_scripts': ['run = {name}.m:main']}})\n"
        )
        files[f"{name}/{name}/__init__.py"] = ""
        files[f"{name}/{name}/m.py"] = _main([f"Node('{name}')"])["m.py"]
    return files


def _parameter_file(n: int) -> Files:
    entries = "".join(f"    p{i}: {i}\n" for i in range(n))
    return {
        **_node([f"self.declare_parameter('p{i}', 0)" for i in range(0, n, 40)]),
        "p.yaml": f"n:\n  ros__parameters:\n{entries}",
    }


def _talking(n: int) -> Files:
    """Copies of one program, each of which listens to the one before."""
    program = f"{_HEAD}rclpy.init()\nn = Node('n')\nn.create_publisher(String, 'out', 1)\nn.create_subscription(String, 'in', print, 1)\n"
    lines = "\n".join(
        f"<node pkg='p' exec='n.py' name='n{i}'><remap from='out' to='t{i}'/><remap from='in' to='t{i - 1}'/></node>"
        for i in range(n)
    )
    cmake = "project(p)\ninstall(PROGRAMS n.py DESTINATION lib/p)\n"
    launch = _LAUNCH.format(lines)
    return {"package.xml": _PACKAGE, "CMakeLists.txt": cmake, "launch/top.launch.xml": launch, "n.py": program}


def _policy(n: int) -> Files:
    topics = "".join(f"<topic>t{i}</topic>" for i in range(n))
    profile = f"<profile ns='/' node='n'><topics publish='ALLOW'>{topics}</topics></profile>"
    text = f"<policy version='0.2.0'><enclaves><enclave path='/n'><profiles>{profile}</profiles></enclave></enclaves></policy>"
    return _node([f"self.create_publisher(String, 't{i}', 1)" for i in range(n)]) | {"policy.xml": text}


_CPP: Final = """
#include <memory>
#include <string>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
using std_msgs::msg::String;
"""


def _cpp(lines: Sequence[str], members: str = "") -> Files:
    """One program in C++ with one node, whose constructor holds these lines."""
    body = "".join(f"    {line}\n" for line in lines)
    return {
        "n.cpp": f'{_CPP}class N : public rclcpp::Node\n{{\npublic:\n  N() : Node("n")\n  {{\n{body}  }}\nprivate:\n{members}'
        "  std::vector<std::shared_ptr<void>> kept_;\n};\n"
        "int main(int argc, char ** argv)\n{\n  rclcpp::init(argc, argv);\n  rclcpp::spin(std::make_shared<N>());\n}\n"
    }


def _cpp_callbacks(n: int) -> Files:
    call = (
        'kept_.push_back(create_subscription<String>("s{0}", 1, [this](String::SharedPtr m) {{last{0}_ = m->data;}}));'
    )
    return _cpp([call.format(i) for i in range(n)], "".join(f"  std::string last{i}_;\n" for i in range(n)))


def _cpp_methods(n: int) -> Files:
    methods = "".join(f"  int level{i}_ = 0;\n  int m{i}() {{level{i}_ = {i}; return level{i}_;}}\n" for i in range(n))
    return _cpp([f"m{i}();" for i in range(n)], methods)


def _cpp_loops(n: int) -> Files:
    """Calls of one function that only computes, from many places."""
    method = "  double cost(double x) {double sum = 0.0; for (int i = 0; i < 5; ++i) {sum += x * i;} return sum;}\n"
    return _cpp([f"cost({i % 10}.5);" for i in range(n)], method)


_EXTRACT: Final = ("extract", "{source}", "-q", "-o", "{out}")
_MORE_STEPS: Final = (*_EXTRACT, "--budget", "10")
"""For programs in C++ that reach the limit of steps with some thousand entities in one process."""
_TOP: Final = "{source}/launch/top.launch.xml"


class Kind(NamedTuple):
    """What grows, and the command that reads it."""

    make: Callable[[int], Files]
    command: tuple[str, ...] = _EXTRACT


KINDS: Final[dict[str, Kind]] = {
    "publishers": Kind(lambda n: _node([f"self.create_publisher(String, 't{i}', 1)" for i in range(n)])),
    "timers": Kind(
        lambda n: _node(
            [f"self.create_timer({i + 1}, self.tick)" for i in range(n)], "    def tick(self):\n        self.n = 1\n"
        )
    ),
    "timers, each its own": Kind(
        lambda n: _node(
            [f"self.create_timer(1.0, self.t{i})" for i in range(n)],
            "".join(f"    def t{i}(self):\n        self.n{i} = {i}\n" for i in range(n)),
        )
    ),
    "subscriptions": Kind(_callbacks),
    "nodes in one process": Kind(lambda n: _main([f"n{i} = Node('n{i}')" for i in range(n)])),
    "processes": Kind(_processes),
    "files": Kind(_files),
    "imports": Kind(_imports),
    "packages": Kind(_packages),
    "parameters": Kind(lambda n: _node([f"self.declare_parameter('p{i}', {i})" for i in range(n)])),
    "entries of a parameter file": Kind(_parameter_file, (*_EXTRACT, "--params", "{source}/p.yaml")),
    "remaps": Kind(_remaps),
    "class chain": Kind(_class_chain),
    "methods": Kind(
        lambda n: _node(
            [f"self.m{i}()" for i in range(n)],
            "".join(f"    def m{i}(self):\n        self.a{i} = 1\n" for i in range(n)),
        )
    ),
    "functions that call each other": Kind(_call_chain),
    "branches": Kind(lambda n: _main([f"if input():\n        x{i} = {i}" for i in range(n)] + ["Node('n')"])),
    "items of a literal": Kind(
        lambda n: _main(
            [
                f"a = [{', '.join(map(str, range(n)))}]",
                f"b = {{{', '.join(f'{i}: {i}' for i in range(n))}}}",
                f"Node('n').create_publisher(String, f't{{a[{n // 2}] + b[{n // 2}]}}', 1)",
            ]
        )
    ),
    "concatenations": Kind(
        lambda n: _main(["t = 't'", *("t += 'x'" for _ in range(n)), "Node('n').create_publisher(String, t, 1)"])
    ),
    "terms of a sum": Kind(
        lambda n: _main(
            [f"t = {' + '.join(repr(f'x{i}') for i in range(n))}", "Node('n').create_publisher(String, t, 1)"]
        )
    ),
    "C++: publishers": Kind(
        lambda n: _cpp([f'kept_.push_back(create_publisher<String>("t{i}", 1));' for i in range(n)]), _MORE_STEPS
    ),
    "C++: subscriptions": Kind(_cpp_callbacks, _MORE_STEPS),
    "C++: methods": Kind(_cpp_methods),
    "C++: calls of one function": Kind(_cpp_loops),
    "C++: casts": Kind(
        lambda n: _cpp([f"at_ = static_cast<int>(at_) + {i};" for i in range(n)], "  int at_ = 0;\n"),
    ),
    "C++: programs": Kind(
        lambda n: {
            f"n{i}.cpp": _cpp([f'kept_.push_back(create_publisher<String>("t{i}", 1));'])["n.cpp"] for i in range(n)
        }
    ),
    "findings": Kind(lambda n: _node([f"self.create_publisher(String, input(), {i})" for i in range(n)])),
    "rules of a policy": Kind(_policy, ("check", "{source}/policy.xml", "{source}", "-o", "{out}")),
    "includes": Kind(_includes, (*_EXTRACT, "--launch", _TOP)),
    "nodes of a launch file": Kind(_launched, (*_EXTRACT, "--launch", _TOP)),
    "programs of a launch file": Kind(_talking, (*_EXTRACT, "--launch", _TOP)),
    "launch files": Kind(_launch_files, (*_EXTRACT, "--all-launch")),
    "nodes of a report": Kind(_talking, (*_EXTRACT, "--format", "html", "--launch", _TOP)),
}


def main() -> int:
    """Measure each kind that is asked for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("kinds", nargs="*", metavar="KIND", help=f"some of: {', '.join(KINDS)}")
    parser.add_argument("--sizes", default="10,100,1000,4000")
    parser.add_argument("--most", type=float, default=1.25, help="the greatest exponent that is well")
    options = parser.parse_args()
    sizes = [int(size) for size in options.sizes.split(",")]
    failed = False
    start = min(_cost({"n.py": "x = 1\n"}, _EXTRACT)[0] or 0.0 for _ in range(5))
    print(f"{'':32}" + "".join(f"{size:>9}" for size in sizes) + "    ratio  exponent       MB")
    for kind in options.kinds or KINDS:
        make, command = KINDS[kind]
        costs = [_least(make(size), command) for size in sizes]
        seconds = [None if cpu is None else max(cpu - start, _LEAST) for cpu, _ in costs]
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


def _least(files: Files, command: Sequence[str]) -> tuple[float | None, float]:
    """What one analysis costs; of a quick one, the least of three: what else the machine does would hide it."""
    first = _cost(files, command)
    if first[0] is None or first[0] > _QUICK:
        return first
    return min((first, _cost(files, command), _cost(files, command)), key=lambda cost: cost[0] or _SECONDS)


def _cost(files: Files, words: Sequence[str]) -> tuple[float | None, float]:
    """CPU seconds (None: it failed) and MB of one analysis."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = Path(folder, "source"), Path(folder, "out")
        for name, text in files.items():
            source.joinpath(name).parent.mkdir(parents=True, exist_ok=True)
            source.joinpath(name).write_text(text, encoding="utf-8")
        command = [sys.executable, "-m", "rosward", *(word.format(source=source, out=out) for word in words)]
        run = measure(command, seconds=_SECONDS)
    return (run.cpu if run.status in (0, 1) else None), run.peak_mb


if __name__ == "__main__":
    sys.exit(main())
