# SPDX-License-Identifier: Apache-2.0
"""Promise: the file that a path below a share folder leads to is found without building anything, and no other file is."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

import pytest

from rosward.source.discover import discover
from rosward.source.installed import Installed
from rosward.source.workspace import TargetKind
from source.trees import manifest, write

FILES = {
    "src/demo/package.xml": manifest("demo"),
    "src/demo/start/left.launch.py": "",
    "src/demo/start/right.launch.py": "",
    "src/demo/start/note.txt": "",
    "src/demo/config/a.yaml": "a: 1\r\nb: 2\n",
    "src/demo/deep/er/only.yaml": "",
    "src/demo/deep/two.yaml": "",
    "src/demo/config/two.yaml": "",
}


def python(data_files: str, before: str = "") -> str:
    return f"import os\nfrom glob import glob\nfrom setuptools import setup\nname = 'demo'\n{before}\nsetup(name=name, data_files={data_files})\n"


def installed(root: Path, more: Mapping[str, str | bytes], *underlays: Path) -> Installed:
    write(root, {**FILES, **more})
    return Installed(discover([root]), underlays)


def found(files: Installed, *paths: str, package: str = "demo") -> list[str | None]:
    return [None if file is None else file.relative for file in (files.share(package, path) for path in paths)]


@pytest.mark.parametrize(
    "data_files",
    [
        "[('share/demo/launch', ['start/left.launch.py', 'start/right.launch.py'])]",
        "[(os.path.join('share', name, 'launch'), glob('start/*.launch.py'))]",
        "[('share/' + name + '/launch/', glob(os.path.join('start', '*launch.[pxy][yma]*')))]",
        "[(f'share/{name}/launch', [f for f in glob('start/*') if f.endswith('.py')])]",
        "[('share/%s/launch' % name, glob('start/**/*.launch.py', recursive=True))]",
        "[('share/demo', ['package.xml']), *[(os.path.join('share', name, 'launch'), [f]) for f in glob('start/*.py')]]",
        "[('share/demo', [])] + [('share/demo/launch', glob('start/left*') + glob('start/right*'))]",
    ],
)
def test_data_files(tmp_path: Path, data_files: str) -> None:
    files = installed(tmp_path, {"src/demo/setup.py": python(data_files)})
    assert found(files, "launch/left.launch.py", "launch/right.launch.py", "launch/absent.launch.py") == [
        "src/demo/start/left.launch.py",
        "src/demo/start/right.launch.py",
        None,
    ]
    assert files.place_of("src/demo/start/left.launch.py") == ("demo", "launch/left.launch.py")


def test_data_files_that_grow(tmp_path: Path) -> None:
    before = "data = []\ndata.append(('share/demo/a', ['start/note.txt']))\nfor f in 'left',:\n    data += [('share/demo/' + f, glob('start/left*'))]"
    files = installed(tmp_path, {"src/demo/setup.py": python("data", before)})
    assert found(files, "a/note.txt", "left/left.launch.py") == [
        "src/demo/start/note.txt",
        "src/demo/start/left.launch.py",
    ]


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ("install(DIRECTORY start DESTINATION share/${PROJECT_NAME})", "start/left.launch.py"),
        ("install(DIRECTORY start/ DESTINATION share/${PROJECT_NAME})", "left.launch.py"),
        ("install(DIRECTORY start/ DESTINATION share/${PROJECT_NAME}/launch)", "launch/left.launch.py"),
        ("install(DIRECTORY config start DESTINATION share/${PROJECT_NAME}/)", "start/left.launch.py"),
        ("install(DIRECTORY start DESTINATION ${CMAKE_INSTALL_DATADIR}/demo)", "start/left.launch.py"),
        ("install(FILES start/left.launch.py DESTINATION share/${PROJECT_NAME}/launch)", "launch/left.launch.py"),
        ("install(PROGRAMS start/left.launch.py DESTINATION share/demo RENAME go.launch.py)", "go.launch.py"),
        ("file(GLOB L start/*.py)\ninstall(FILES ${L} DESTINATION share/demo/launch)", "launch/left.launch.py"),
        ("foreach(d config start)\ninstall(DIRECTORY ${d}/ DESTINATION share/demo/${d}_x)\nendforeach()", "start_x/left.launch.py"),
        ("ament_auto_package(INSTALL_TO_SHARE config start)", "start/left.launch.py"),
        ("install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/start DESTINATION share/demo FILES_MATCHING PATTERN *.py)", "start/left.launch.py"),
    ],
)  # fmt: skip
def test_cmake(tmp_path: Path, text: str, path: str) -> None:
    more = {
        "src/demo/package.xml": manifest("demo", "ament_cmake"),
        "src/demo/CMakeLists.txt": f"project(demo)\n{text}\n",
    }
    files = installed(tmp_path, more)
    assert found(files, path, f"./x/../{path}") == ["src/demo/start/left.launch.py"] * 2


def test_project_within_a_project(tmp_path: Path) -> None:
    """Its name does not last beyond its folder."""
    more = {
        "src/demo/package.xml": manifest("demo", "ament_cmake"),
        "src/demo/CMakeLists.txt": "project(demo)\nadd_subdirectory(lib)\ninstall(FILES start/note.txt DESTINATION share/${PROJECT_NAME}/a)\n",
        "src/demo/lib/CMakeLists.txt": "project(lib)\n",
    }
    assert found(installed(tmp_path, more), "a/note.txt") == ["src/demo/start/note.txt"]


def test_what_no_rule_says(tmp_path: Path) -> None:
    """The same path in the package, else the only file of that name; never one of two."""
    files = installed(tmp_path, {"src/demo/setup.py": python("[]")})
    assert found(files, "config/a.yaml", "params/only.yaml", "params/two.yaml", "package.xml") == [
        "src/demo/config/a.yaml",
        "src/demo/deep/er/only.yaml",
        None,
        "src/demo/package.xml",
    ]


@pytest.mark.parametrize(
    "path",
    ["../other/x.yaml", "a/../../x", "", ".", "/", "a\0b", "x" * 5000, "x" * 300, "\ud800", "config", "config/../.."],
)
def test_no_file(tmp_path: Path, path: str) -> None:
    files = installed(tmp_path, {"src/demo/setup.py": python("[]"), "src/other/x.yaml": ""})
    assert found(files, path) == [None]
    assert found(files, "x.yaml", package="../other") == [None]


def test_links_that_lead_outside(tmp_path: Path) -> None:
    write(tmp_path, {"secret.yaml": "x: 1", "ws/src/demo/package.xml": manifest("demo"), "ws/src/demo/in.yaml": ""})
    (tmp_path / "ws/src/demo/out.yaml").symlink_to(tmp_path / "secret.yaml")
    (tmp_path / "ws/src/demo/fifo.yaml").unlink(missing_ok=True)
    os.mkfifo(tmp_path / "ws/src/demo/fifo.yaml")
    files = Installed(discover([tmp_path / "ws/src"]))
    assert found(files, "in.yaml", "out.yaml", "fifo.yaml") == ["demo/in.yaml", None, None]


def test_text(tmp_path: Path) -> None:
    more = {"src/demo/binary.yaml": b"a\0b", "src/demo/latin.yaml": b"\xe9", "src/demo/big.yaml": b"x" * 1_000_001}
    files = installed(tmp_path, more)
    assert files.read("demo", "config/a.yaml") == "a: 1\nb: 2\n"
    assert files.read("", "src/demo/config/a.yaml") == "a: 1\nb: 2\n"
    assert [files.read("demo", name) for name in ("binary.yaml", "latin.yaml", "big.yaml", "absent.yaml")] == [None] * 4
    assert files.read("", "../x") is None


def test_listing(tmp_path: Path) -> None:
    """What is in a folder is told only where all of it is."""
    rules = "[('share/demo/launch', glob('start/*.py')), ('share/demo/launch/more', ['config/a.yaml'])]"
    files = installed(tmp_path, {"src/demo/setup.py": python(rules)})
    assert files.listing("demo", "launch") == ("left.launch.py", "more", "right.launch.py")
    assert files.listing("demo", "config") is None
    assert files.listing("demo", "") is None
    assert [files.is_folder("demo", path) for path in ("launch", "launch/more", "", "config")] == [
        True,
        True,
        True,
        False,
    ]
    unsure = installed(tmp_path / "b", {"src/demo/setup.py": python(f"{rules} + more()")})
    assert unsure.listing("demo", "launch") is None
    assert found(unsure, "launch/left.launch.py") == ["src/demo/start/left.launch.py"]


def test_listing_of_a_folder_of_cmake(tmp_path: Path) -> None:
    package = {"src/demo/package.xml": manifest("demo", "ament_cmake")}
    rule = "install(DIRECTORY start DESTINATION share/demo{})"
    files = installed(tmp_path / "a", {**package, "src/demo/CMakeLists.txt": rule.format("")})
    assert files.listing("demo", "start") == ("left.launch.py", "note.txt", "right.launch.py")
    files = installed(tmp_path / "b", {**package, "src/demo/CMakeLists.txt": rule.format(" PATTERN *.txt EXCLUDE")})
    assert files.listing("demo", "start") is None
    assert files.is_folder("demo", "start")


@pytest.mark.parametrize("isolated", [True, False])
def test_install_prefix(tmp_path: Path, isolated: bool) -> None:
    prefix = tmp_path / "install"
    share = "nav/share/nav" if isolated else "share/nav"
    write(prefix, {"local_setup.bash": "", f"{share}/launch/bringup.launch.py": "", f"{share}/package.xml": ""})
    files = installed(tmp_path / "ws", {"src/demo/setup.py": python("[]")}, prefix)
    assert files.has_package("nav")
    assert not files.has_package("nowhere")
    name = str(prefix / share / "launch/bringup.launch.py")
    assert found(files, "launch/bringup.launch.py", "../demo/x", package="nav") == [name, None]
    assert files.listing("nav", "launch") == ("bringup.launch.py",)
    assert files.place_of(name) == ("nav", "launch/bringup.launch.py")
    assert files.file(name) is not None
    assert found(files, "x" * 300, "\ud800", "a\0", package="nav") == [None] * 3
    assert not files.is_folder("nav", "x" * 300)


def test_overlay_comes_first(tmp_path: Path) -> None:
    """A package of the workspace hides the whole of that in an underlay."""
    near, far = tmp_path / "near", tmp_path / "far"
    for folder, name in ((near, "near"), (far, "far")):
        write(
            folder,
            {
                "src/nav/package.xml": manifest("nav"),
                f"src/nav/{name}.yaml": "",
                "src/demo/package.xml": manifest("demo"),
            },
        )
        write(folder, {"src/demo/under.yaml": "", f"src/{name}/package.xml": manifest(name), f"src/{name}/x.yaml": ""})
    files = installed(tmp_path / "ws", {"src/demo/setup.py": python("[]")}, near, far)
    assert found(files, "under.yaml") == [None]
    assert found(files, "near.yaml", "far.yaml", package="nav") == [f"{near}/src/nav/near.yaml", None]
    assert found(files, "x.yaml", package="far") == [f"{far}/src/far/x.yaml"]


TARGETS = """
project(demo)
add_executable(talker src/talker.cpp)
add_executable(hidden src/hidden.cpp)
add_executable(${PROJECT_NAME}_node src/a.cpp)
add_library(parts SHARED src/parts.cpp)
rclcpp_components_register_node(parts PLUGIN "demo::Arm" EXECUTABLE arm)
rclcpp_components_register_nodes(parts "demo::Hand" "demo::Foot")
install(TARGETS talker ${PROJECT_NAME}_node RUNTIME DESTINATION lib/${PROJECT_NAME})
install(TARGETS parts hidden ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
ament_auto_add_executable(auto src/auto.cpp)
"""


def test_targets(tmp_path: Path) -> None:
    write(tmp_path, {"demo/package.xml": manifest("demo", "ament_cmake"), "demo/CMakeLists.txt": TARGETS})
    targets = [(t.name, t.kind, t.plugin, t.place.line) for t in discover([tmp_path]).targets]
    assert targets == [
        ("arm", TargetKind.EXECUTABLE, "demo::Arm", 7),
        ("auto", TargetKind.EXECUTABLE, "", 11),
        ("demo_node", TargetKind.EXECUTABLE, "", 5),
        ("parts", TargetKind.COMPONENT, "demo::Arm", 7),
        ("parts", TargetKind.COMPONENT, "demo::Foot", 8),
        ("parts", TargetKind.COMPONENT, "demo::Hand", 8),
        ("talker", TargetKind.EXECUTABLE, "", 3),
    ]
