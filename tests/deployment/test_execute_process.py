# SPDX-License-Identifier: Apache-2.0
"""Command lines: nodes of `ros2 run`, systems of `ros2 launch`, scripts, and other programs."""

from __future__ import annotations

import pytest

from deployment.execution import HERE, UNKNOWN, Run, share, shown, text
from rosward.deployment import tree
from rosward.deployment.started import StartKind
from rosward.domain.text import concat
from rosward.domain.values import Const
from rosward.models.python.shell.words import split


def process(*words: str, shell: bool = False) -> tree.StartProcess:
    return tree.StartProcess(place=HERE, command=tuple(text(w) for w in words), shell=shell)


@pytest.mark.parametrize(
    ("action", "line"),
    [
        (process("ros2", "run", "demo", "talker", "-v"), "demo/talker -v"),
        (process("ros2", "run", "--prefix", "gdb -ex run", "demo", "talker"), "demo/talker"),
        (process("ros2 run demo talker --ros-args -r 'a:=b c'", shell=True), "demo/talker --ros-args -r a:=b c"),
        (process("python3", "/opt/tool.py", "--fast"), "/opt/tool.py --fast"),
        (process("python3", "-m", "http.server"), "python3 -m http.server"),
        (process("ros2", "bag", "record", "-a"), "ros2 bag record -a"),
        (process("gzserver"), "gzserver"),
    ],
)
def test_command_lines(action: tree.StartProcess, line: str) -> None:
    assert Run([action]).lines == [line]


@pytest.mark.parametrize(
    ("line", "lines"),
    [
        ("sleep 5; ros2 run demo talker", ["sleep 5", "demo/talker"]),
        ("ros2 run demo a & ros2 run demo b -v", ["demo/a", "demo/b -v"]),
        ("cd /tmp && exec ros2 run demo a --x > /tmp/log 2>&1", ["demo/a --x"]),
        ("source /opt/ros/setup.bash\nros2 run demo a \\\n  -v", ["demo/a -v"]),
        ("nice -n 5 ros2 run demo a | tee 'a; b'", ["demo/a", "tee a; b"]),
        ("timeout -k 2 10 stdbuf -oL ros2 run demo a", ["demo/a"]),
        ("bash -lc 'ros2 run demo a; exec bash'", ["demo/a"]),
        ("while true; do ros2 run demo a; done", ["demo/a"]),
        ("(ros2 run demo a || echo 'no & no') && ros2 run demo b", ["demo/a", "echo no & no", "demo/b"]),
        ("ros2 run demo a --x '$HOME' \"$(hostname)\" `date` ${SIDE}x", ["demo/a --x $HOME * * *x"]),
        ("while [ -z `ros2 run demo a $(ros2 run demo b)` ]; do sleep 3; done", ["demo/b", "demo/a *", "sleep 3"]),
        ("ros2 run demo 'a", ["demo/a"]),
        ("ros2 run demo a # ; ros2 run demo b\nros2 run demo c#d", ["demo/a", "demo/c#d"]),
        ("cat <<EOF > x\nros2 run demo a\nEOF\nros2 run demo b", ["cat", "demo/b"]),
        ("bash -s <<'EOF'\nros2 run demo a\nEOF\nros2 run demo b", ["demo/a", "demo/b"]),
        ("f() { ros2 run demo a; }; f", ["demo/a"]),
        ("function f { ros2 run demo a; }; f", ["demo/a"]),
        ("grep ';' x | cut -d '|' -f1", ["grep ; x", "cut -d | -f1"]),
        ("trap 'ros2 run demo a' EXIT; eval \"ros2 run demo b\"", ["demo/a", "demo/b"]),
        ("taskset -c 1 ros2 run demo a; sudo -n -u ros-user ros2 run demo b", ["demo/a", "demo/b"]),
        ("ros2 run demo a 2>&1 >/dev/null&ros2 run demo b<in&&ros2 run demo c", ["demo/a", "demo/b", "demo/c"]),
        ("cat <(ros2 run demo a)", ["cat", "demo/a"]),
    ],
)
def test_lines_of_a_shell(line: str, lines: list[str]) -> None:
    assert Run([process(line, shell=True)]).lines == lines


@pytest.mark.parametrize(
    ("line", "lines"),
    [
        ("X=a; ros2 run demo $X", ["demo/a"]),
        ("export X=a Y=b && ros2 run demo $X$Y", ["demo/ab"]),
        ("X='a -v'; ros2 run demo $X; ros2 run demo \"$X\"", ["demo/a -v", "demo/a -v"]),
        ("X=a bash -c 'ros2 run demo $X'; ros2 run demo $X", ["demo/a", "demo/*"]),
        ("ros2 run demo ${X:-a}; X=b; ros2 run demo ${X:-a}", ["demo/a", "demo/b"]),
        ("(X=a; ros2 run demo $X); ros2 run demo $X", ["demo/a", "demo/*"]),
        ("X=a; [ -f x ] && X=b; ros2 run demo $X", ["demo/*"]),
        ("X=a; if [ -f x ]; then X=b; fi; ros2 run demo $X", ["demo/*"]),
        ("X=a; for X in b c; do ros2 run demo $X; done", ["demo/*"]),
        ("X=a; read X; ros2 run demo $X", ["demo/*"]),
        ("X=a & ros2 run demo $X", ["demo/*"]),
        ("true || X=a; ros2 run demo $X", ["demo/*"]),
        ("X=a; f() { X=b; }; f; ros2 run demo $X", ["demo/*"]),
        ("X=a; while true; do ros2 run demo $X; X=b; done", ["demo/*"]),
    ],
)
def test_variables_of_a_shell(line: str, lines: list[str]) -> None:
    assert Run([process(line, shell=True)]).lines == lines


def test_a_long_line_of_a_shell_is_read_in_time() -> None:
    for long in (
        "bash <<A\n" * 10_000,
        "$(" * 10_000,
        "$(" * 4_000 + ")" * 4_000,
        "`'\"" * 6_000,
        "a;" * 4_000,
        "X=ab;" + "X=$X$X;" * 60,
        "X=1;" * 4_000,
        "<<A\n" * 2_000,
        "(" * 10_000,
        "${" * 10_000,
    ):
        assert Run([process(long + "\nros2 run demo a", shell=True)]).lines is not None


@pytest.mark.parametrize(
    "line",
    [
        "",
        "&<",
        "&&>",
        "<<",
        "<<<",
        ";;",
        "|&",
        "$",
        "\\",
        "a\\",
        "'",
        "`",
        "$(",
        "${",
        ")",
        "()",
        "x()",
        "export",
        "function",
        "for",
        "\0",
        "a 2>",
        "eval",
        "trap",
        "&>",
        "\ud800",
        "<<A",
        "bash <<A",
        "exec",
        "env",
        "X=",
    ],
)
def test_odd_lines_of_a_shell(line: str) -> None:
    Run([process(line, shell=True)])
    Run([process(f"{line} ros2 run demo a", shell=True)])


@pytest.mark.parametrize(
    "words",
    [
        ("bash", "-c", "ros2 run demo talker"),
        ("xterm", "-hold", "-e", "ros2", "run", "demo", "talker"),
        ("xterm", "-e", "ros2 run demo talker"),
        ("gnome-terminal", "--tab", "--", "bash", "-c", "ros2 run demo talker; exec bash"),
        ("sudo", "-E", "ros2", "run", "demo", "talker"),
    ],
)
def test_a_program_that_starts_another_one(words: tuple[str, ...]) -> None:
    assert Run([process(*words)]).lines == ["demo/talker"]


def test_variables_of_one_command() -> None:
    one, two = Run([process("A=1 ros2 run demo a; export C=3; env B=2 ros2 run demo b", shell=True)]).started
    assert one.configuration.environment == {"A": Const("1")}
    assert two.configuration.environment == {"B": Const("2"), "C": Const("3")}


def test_kinds() -> None:
    run = Run([process("ros2", "run", "demo", "talker"), process("python3", "a.py"), process("ls")])
    assert [s.kind for s in run.started] == [StartKind.NODE, StartKind.PROCESS, StartKind.PROCESS]
    assert [[shown(w) for w in s.command] for s in run.started][1] == ["python3", "a.py"]


def test_a_path_to_ros2() -> None:
    found = (tree.Substitution("find-exec", (text("ros2"),), HERE),)
    action = tree.StartProcess(place=HERE, command=((*found, Const(" run demo talker ")), (UNKNOWN,)), shell=True)
    assert Run([action]).lines == ["demo/talker *"]


def test_ros2_launch_is_a_system_of_its_own() -> None:
    """It sees the environment, but neither configurations nor namespaces."""
    inner = """<launch><arg name="x" default="d"/><node pkg="p" exec="$(var x)" name="$(var y none)"/></launch>"""
    main = """<let name="y" value="outer"/><set_env name="E" value="1"/><push_ros_namespace namespace="a"/>
        <executable cmd="ros2 launch other a.launch.xml x:=given"/>"""
    run = Run(main, {"other/launch/a.launch.xml": inner})
    assert run.lines == ["p/given --ros-args -r __node:=none"]
    assert run.started[0].configuration.environment == {"E": Const("1")}
    assert len(run.started[0].trail) == 1


def test_ros2_launch_of_a_file_that_is_not_there() -> None:
    assert Run([process("ros2", "launch", "acme", "a.launch.py")]).codes == ["RW311"]


def test_ros2_launch_of_itself_ends() -> None:
    command = (text("ros2"), text("launch"), (share("demo", "/launch/main.launch.py"),))
    assert Run([tree.StartProcess(place=HERE, command=command)]).codes == ["RW201"]


def test_the_environment_of_a_process() -> None:
    own = ((text("A"), text("2")),)
    first = tree.Environ(place=HERE, how="set", name=text("B"), value=text("1"))
    added, alone = (
        tree.StartProcess(place=HERE, command=(text("x"),), environment=own, replaces_environment=whole)
        for whole in (False, True)
    )
    one, two = Run([first, added, alone]).started
    assert one.configuration.environment == {"A": Const("2"), "B": Const("1")}
    assert two.configuration.environment == {"A": Const("2")}


def test_words_of_a_shell() -> None:
    line = concat((Const("a 'b c' "), UNKNOWN, Const('/d "e')))
    assert [shown(w) for w in split(line)] == ["a", "'b", "c'", "*/d", '"e']
    assert [shown(w) for w in split(concat((Const("a 'b "), UNKNOWN, Const("' c"))))] == ["a", "b *", "c"]
