# SPDX-License-Identifier: Apache-2.0
"""Promise: every source file is found once, in a fixed order, and what is left out is said."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rosward.source.discover import discover
from rosward.source.workspace import ExecutableKind, SkipReason
from source.trees import codes, file, manifest, names, python_package, read, setup, write


def test_a_package(tmp_path: Path) -> None:
    found = read(tmp_path, python_package("demo", "talker", commands=("talker = demo.talker:main",)))
    assert names(found) == ["demo/demo/__init__.py", "demo/demo/talker.py"]
    assert [file.module for file in found.files] == ["demo", "demo.talker"]
    (package,) = found.packages
    assert (package.name, package.relative, package.build_type) == ("demo", "demo", "ament_python")
    (talker,) = found.executables
    assert (talker.package, talker.name, talker.kind) == (package, "talker", ExecutableKind.CONSOLE_SCRIPT)
    assert (talker.file, talker.module, talker.function) == (found.files[1], "demo.talker", "main")
    assert str(talker.place) == "demo/setup.py:4"
    assert found.findings == ()


def test_what_a_package_needs(tmp_path: Path) -> None:
    extra = (
        "<depend>rclpy</depend><exec_depend>tf2_ros</exec_depend><test_depend>pytest</test_depend>"
        '<exec_depend condition="$ROS_VERSION == 1">rospy</exec_depend>'
    )
    found = read(tmp_path, {"package.xml": manifest("demo", extra=extra)})
    assert found.packages[0].depends == {"rclpy", "tf2_ros"}


def test_the_build_type_of_ros_2_counts(tmp_path: Path) -> None:
    text = manifest("demo").replace(
        "<build_type>ament_python</build_type>",
        '<build_type condition="$ROS_VERSION == 1">catkin</build_type>'
        '<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>',
    )
    assert read(tmp_path, {"package.xml": text}).packages[0].build_type == "ament_cmake"


@pytest.mark.parametrize("name", ["build", "install", "log"])
def test_output_beside_src_is_skipped(tmp_path: Path, name: str) -> None:
    found = read(tmp_path, {"repo/ws/src/a.py": "", f"repo/ws/{name}/demo/b.py": ""})
    assert names(found) == ["repo/ws/src/a.py"]
    assert [(s.relative, s.reason) for s in found.skipped] == [(f"repo/ws/{name}", SkipReason.BUILD_OUTPUT)]


def test_output_at_the_top_is_skipped(tmp_path: Path) -> None:
    assert names(read(tmp_path, {"a.py": "", "build/b.py": "", "install/c.py": "", "log/d.py": ""})) == ["a.py"]


def test_output_with_the_marks_of_colcon_is_skipped(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "demo/package.xml": manifest("demo"),
            "demo/a.py": "",
            "demo/build/.built_by": "colcon",
            "demo/build/b.py": "",
            "demo/install/local_setup.bash": "",
            "demo/install/c.py": "",
        },
    )
    assert names(found) == ["demo/a.py"]


def test_a_source_folder_named_build_is_read(tmp_path: Path) -> None:
    files = python_package("demo") | {"demo/demo/build/planner.py": "", "demo/demo/log/writer.py": ""}
    assert names(read(tmp_path, files))[1:] == ["demo/demo/build/planner.py", "demo/demo/log/writer.py"]


def test_a_package_named_log_is_read(tmp_path: Path) -> None:
    assert names(read(tmp_path, python_package("log"))) == ["log/log/__init__.py"]


def test_the_copies_of_setuptools_are_skipped(tmp_path: Path) -> None:
    files = python_package("demo", "a") | {"demo/build/lib/demo/a.py": ""}
    assert "demo/build/lib/demo/a.py" not in names(read(tmp_path, files))


@pytest.mark.parametrize("marker", ["COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"])
def test_marked_folders_are_skipped(tmp_path: Path, marker: str) -> None:
    found = read(tmp_path, {"a.py": "", f"old/{marker}": "", "old/b.py": "", "old/deep/c.py": ""})
    assert names(found) == ["a.py"]
    assert found.skipped[0].reason is SkipReason.IGNORED


def test_environments_and_hidden_folders_are_skipped(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "a.py": "",
            "env/pyvenv.cfg": "",
            "env/lib/b.py": "",
            "x/site-packages/c.py": "",
            "node_modules/d.py": "",
            ".cache/e.py": "",
            "__pycache__/f.py": "",
            ".hidden.py": "",
        },
    )
    assert names(found) == ["a.py"]


def test_tests_are_skipped_unless_asked(tmp_path: Path) -> None:
    files = dict.fromkeys(
        ["a.py", "test/b.py", "tests/c.py", "test_d.py", "e_test.py", "conftest.py", "contest.py"], ""
    )
    assert names(read(tmp_path, files)) == ["a.py", "contest.py"]
    assert names(discover([tmp_path], include_tests=True)) == sorted(files)


def test_a_package_named_test_is_no_test(tmp_path: Path) -> None:
    assert names(read(tmp_path, python_package("test", "node"))) == ["test/test/__init__.py", "test/test/node.py"]


def test_a_test_file_that_an_entry_point_names_is_read(tmp_path: Path) -> None:
    files = python_package("demo", "test_drive", "test_unit", commands=("drive = demo.test_drive:main",))
    found = read(tmp_path, files)
    assert names(found) == ["demo/demo/__init__.py", "demo/demo/test_drive.py"]
    assert found.executables[0].file is found.files[1]
    assert [s.relative for s in found.skipped if s.reason is SkipReason.TEST] == ["demo/demo/test_unit.py"]


def test_a_named_file_is_read_whatever_it_is_called(tmp_path: Path) -> None:
    write(tmp_path, {"build/test_x.py": "", "build/y.py": "", "script": ""})
    found = discover([tmp_path / "build" / "test_x.py", tmp_path / "script"])
    assert names(found) == ["build/test_x.py", "script"]


def test_a_named_folder_is_read_whatever_it_is_called(tmp_path: Path) -> None:
    write(tmp_path, {".x/tests/COLCON_IGNORE": "", ".x/tests/a.py": ""})
    assert names(discover([tmp_path / ".x" / "tests"])) == ["a.py"]


def test_the_root_is_what_the_paths_have_in_common(tmp_path: Path) -> None:
    write(tmp_path, {"a/x.py": "", "b/c/y.py": "", "d/z.py": ""})
    found = discover([tmp_path / "b" / "c", tmp_path / "a"])
    assert found.root == tmp_path
    assert names(found) == ["a/x.py", "b/c/y.py"]


def test_paths_within_each_other_give_each_file_once(tmp_path: Path) -> None:
    write(tmp_path, {"a/x.py": "", "y.py": ""})
    found = discover([tmp_path / "a", tmp_path, tmp_path / "a" / "x.py", tmp_path])
    assert names(found) == ["a/x.py", "y.py"]


def test_a_missing_path_is_told(tmp_path: Path) -> None:
    found = discover([tmp_path / "nowhere"])
    assert codes(found) == [("RW002", "nowhere")]
    assert found.files == ()


def test_no_path_means_here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {"a.py": ""})
    monkeypatch.chdir(tmp_path)
    assert names(discover([])) == names(discover([Path()])) == ["a.py"]


def test_a_single_file_knows_its_package_and_its_executables(tmp_path: Path) -> None:
    commands = ("talker = demo.talker:main", "other = demo.other:main", "gone = demo.gone:main")
    write(tmp_path, python_package("demo", "talker", "other", commands=commands))
    found = discover([tmp_path / "demo" / "demo" / "talker.py"])
    assert names(found) == ["talker.py"]
    assert found.files[0].module == "demo.talker"
    assert [(e.name, str(e.place)) for e in found.executables] == [("talker", "../setup.py:4")]
    assert found.findings == ()


def test_a_folder_within_a_package_knows_it_too(tmp_path: Path) -> None:
    write(tmp_path, python_package("demo", "talker", commands=("talker = demo.talker:main",)))
    found = discover([tmp_path / "demo" / "demo"])
    assert [e.name for e in found.executables] == ["talker"]


def test_the_package_above_is_not_sought_beyond_the_repository(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest("outer"), "repo/.git/": "", "repo/a.py": ""})
    assert discover([tmp_path / "repo" / "a.py"]).packages == ()


def test_launch_files_are_no_nodes(tmp_path: Path) -> None:
    launch = "def generate_launch_description():\n    pass\n"
    found = read(
        tmp_path,
        {
            "a.launch.py": "",
            "launch/b.py": launch,
            "launch/deep/c.py": launch,
            "launch/helper.py": "x = 1\n",
            "launch/writer.py": "# generate_launch_description\nTEXT = 'def generate_launch_description():'\n",
            "launch/template.py": 'TEXT = """\ndef generate_launch_description():\n    pass\n"""\n',
            "launch/taken.py": "from demo.common import (\n    generate_launch_description,\n)\n",
            "launch/taken_late.py": "import sys; sys.path.append('..'); from demo.common import generate_launch_description\n",
            "launch/set.py": "from demo.common import made\nglobals()['generate_launch_description'] = made\n",
            "launch/broken.py": "def generate_launch_description(:\n",
            "d_launch.py": launch,
            "e.py": launch,
            "examples/launch_from_bag.py": launch,
            "examples/launch_helper.py": "x = 1\n",
            "launch/f.launch.xml": "",
            "g.launch": "",
        },
    )
    assert names(found) == [
        "e.py",
        "examples/launch_from_bag.py",
        "examples/launch_helper.py",
        "launch/helper.py",
        "launch/template.py",
        "launch/writer.py",
    ]
    assert [file.relative for file in found.launch_files] == [
        "a.launch.py",
        "d_launch.py",
        "examples/launch_from_bag.py",
        "g.launch",
        "launch/b.py",
        "launch/broken.py",
        "launch/deep/c.py",
        "launch/f.launch.xml",
        "launch/set.py",
        "launch/taken.py",
        "launch/taken_late.py",
    ]


def test_a_weak_name_alone_makes_no_launch_file_of_yaml(tmp_path: Path) -> None:
    """Other tools call their files `…_launch.yml`, too; launch reads none without its key, and tells so of what is named for it."""
    found = read(
        tmp_path,
        {
            "a.py": "",
            "windows_launch.yml": "name: windows\nwindows:\n- launch: ros2 launch demo demo.launch.py\n",
            "robot_launch.yaml": "# robot\nlaunch:\n- node: {pkg: demo, exec: talker}\n",
            "flow_launch.yml": "{'launch': []}\n",
            "marked_launch.yml": "\ufefflaunch: []\n",
            "begun_launch.yml": "--- {launch: []}\n",
            "empty.launch.yaml": "name: empty\n",
        },
    )
    assert [file.relative for file in found.launch_files] == [
        "begun_launch.yml",
        "empty.launch.yaml",
        "flow_launch.yml",
        "marked_launch.yml",
        "robot_launch.yaml",
    ]


def test_build_scripts_are_no_nodes_but_a_module_named_setup_is(tmp_path: Path) -> None:
    files = python_package("demo") | {"demo/demo/setup.py": "import rclpy\n"}
    found = read(tmp_path, files)
    assert names(found) == ["demo/demo/__init__.py", "demo/demo/setup.py"]


def test_scripts_without_suffix_are_found_by_cmake(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "package.xml": manifest("demo", "ament_cmake"),
            "CMakeLists.txt": "install(PROGRAMS nodes/talker nodes/run DESTINATION lib/${PROJECT_NAME})\n",
            "nodes/talker": "#!/usr/bin/env python3\nimport rclpy\n",
            "nodes/run": "#!/bin/bash\n",
            "nodes/README": "text",
        },
    )
    assert names(found) == ["nodes/talker"]
    (talker,) = found.executables
    assert (talker.name, talker.kind, talker.file) == ("talker", ExecutableKind.SCRIPT, found.files[0])


def test_scripts_of_setup_py(tmp_path: Path) -> None:
    text = setup("demo", more="scripts=['bin/talker'],")
    files = {"package.xml": manifest("demo"), "setup.py": text, "bin/talker": "#!/usr/bin/python3\n"}
    found = read(tmp_path, files)
    assert [(e.name, e.kind) for e in found.executables] == [("talker", ExecutableKind.SCRIPT)]


def test_package_dir_leads_to_the_sources(tmp_path: Path) -> None:
    text = setup("demo", "talker = demo.talker:main", more="package_dir={'': 'lib'},")
    files = {"package.xml": manifest("demo"), "setup.py": text, "lib/demo/__init__.py": "", "lib/demo/talker.py": ""}
    found = read(tmp_path, files)
    assert found.executables[0].file is file(found, "lib/demo/talker.py")
    assert found.findings == ()
    assert found.packages[0].python_roots == (tmp_path / "lib",)


def test_an_entry_point_may_name_another_package(tmp_path: Path) -> None:
    files = python_package("demo", commands=("talker = lib_pkg.talker:main",)) | python_package("lib_pkg", "talker")
    found = read(tmp_path, files)
    assert found.executables[0].file is file(found, "lib_pkg/lib_pkg/talker.py")
    assert found.findings == ()


def test_an_entry_point_without_source_is_told(tmp_path: Path) -> None:
    found = read(tmp_path, python_package("demo", commands=("talker = demo.talker:main",)))
    assert codes(found) == [("RW009", "demo/setup.py:4")]
    assert found.executables[0].file is None


def test_a_python_package_without_manifest(tmp_path: Path) -> None:
    files = {"setup.py": setup("demo", "talker = demo.talker:main"), "demo/__init__.py": "", "demo/talker.py": ""}
    found = read(tmp_path, files)
    assert [(p.name, p.build_type) for p in found.packages] == [("demo", "python")]
    assert found.executables[0].file is file(found, "demo/talker.py")


def test_two_workspaces_with_one_package_name(tmp_path: Path) -> None:
    files = python_package("demo", "talker", commands=("talker = demo.talker:main",))
    found = read(tmp_path, {f"{ws}/src/{name}": text for ws in ("ws1", "ws2") for name, text in files.items()})
    assert [p.relative for p in found.packages] == ["ws1/src/demo", "ws2/src/demo"]
    assert [e.file and e.file.relative for e in found.executables] == [
        "ws1/src/demo/demo/talker.py",
        "ws2/src/demo/demo/talker.py",
    ]


def test_the_innermost_package_owns_a_file(tmp_path: Path) -> None:
    files = {"package.xml": manifest("outer"), "sub/package.xml": manifest("inner"), "sub/a.py": "", "b.py": ""}
    found = read(tmp_path, files)
    assert [(f.relative, f.package and f.package.name) for f in found.files] == [
        ("b.py", "outer"),
        ("sub/a.py", "inner"),
    ]


def test_a_link_to_a_folder_above_ends(tmp_path: Path) -> None:
    write(tmp_path, {"src/a.py": ""})
    (tmp_path / "src" / "loop").symlink_to(tmp_path)
    (tmp_path / "src" / "self").symlink_to("self")
    assert names(discover([tmp_path])) == ["src/a.py"]


def test_a_file_with_two_names_is_read_once_by_its_plain_one(tmp_path: Path) -> None:
    write(tmp_path, {"z/a.py": "", "b/": ""})
    (tmp_path / "b" / "linked.py").symlink_to(tmp_path / "z" / "a.py")
    (tmp_path / "a").symlink_to(tmp_path / "z")
    assert names(discover([tmp_path])) == ["z/a.py"]


def test_a_link_to_a_package_outside_is_told_and_followed_only_where_that_is_asked_for(tmp_path: Path) -> None:
    write(
        tmp_path, {f"store/{name}": text for name, text in python_package("demo", "talker").items()} | {"ws/src/": ""}
    )
    (tmp_path / "ws" / "src" / "demo").symlink_to(tmp_path / "store" / "demo")
    left = discover([tmp_path / "ws"])
    assert names(left) == []
    assert codes(left) == [("RW012", "src/demo")]
    there = ["src/demo/demo/__init__.py", "src/demo/demo/talker.py"]
    assert names(discover([tmp_path / "ws"], follow_links=True)) == there
    assert names(discover([tmp_path / "ws" / "src" / "demo"])) == ["demo/__init__.py", "demo/talker.py"]
    assert codes(discover([tmp_path / "ws", tmp_path / "store"])) == []


@pytest.mark.parametrize(
    "name",
    ["talker.py", "robot.launch.xml", "Speed.msg", "package.xml", "setup.py", "CMakeLists.txt", "bringup.launch"],
)
def test_a_link_to_a_file_outside_is_told(tmp_path: Path, name: str) -> None:
    write(tmp_path, {f"store/{name}": "", "ws/src/demo/a.py": ""})
    (tmp_path / "ws" / "src" / "demo" / name).symlink_to(tmp_path / "store" / name)
    found = discover([tmp_path / "ws"])
    assert names(found) == ["src/demo/a.py"]
    assert not [*found.launch_files, *found.interface_files, *found.packages]
    assert codes(found) == [("RW012", f"src/demo/{name}")]


def test_links_that_nothing_would_read_are_not_told(tmp_path: Path) -> None:
    write(tmp_path, {"store/map.png": "", "store/cache/a.py": "", "ws/a.py": ""})
    for link, target in {"map.png": "map.png", ".cache": "cache", "__pycache__": "cache"}.items():
        (tmp_path / "ws" / link).symlink_to(tmp_path / "store" / target)
    assert codes(discover([tmp_path / "ws"])) == []


def test_links_within_what_is_named_are_followed(tmp_path: Path) -> None:
    write(tmp_path, {f"ws/store/{name}": text for name, text in python_package("demo", "talker").items()})
    (tmp_path / "ws" / "src").mkdir()
    (tmp_path / "ws" / "src" / "demo").symlink_to("../store/demo")
    assert codes(discover([tmp_path / "ws"])) == []
    (tmp_path / "way").symlink_to("ws")
    assert codes(discover([tmp_path / "way"])) == []


def test_nothing_is_read_through_a_link_in_a_build_description(tmp_path: Path) -> None:
    """CMake includes, scripts without a suffix, and modules that an import finds beside the files that were named."""
    cmake = "project(demo)\ninclude(rest.cmake)\ninstall(PROGRAMS scripts/talk DESTINATION lib/demo)\n"
    write(
        tmp_path,
        {
            "store/rest.cmake": "install(PROGRAMS scripts/other DESTINATION lib/demo)",
            "store/talk": "#!/usr/bin/env python3\nimport rclpy\n",
            "ws/demo/package.xml": manifest("demo", build_type="ament_cmake"),
            "ws/demo/CMakeLists.txt": cmake,
            "ws/demo/scripts/other": "#!/usr/bin/env python3\nimport rclpy\n",
        },
    )
    (tmp_path / "ws/demo/rest.cmake").symlink_to(tmp_path / "store/rest.cmake")
    (tmp_path / "ws/demo/scripts/talk").symlink_to(tmp_path / "store/talk")
    found = discover([tmp_path / "ws"])
    assert names(found) == []
    assert codes(found) == [("RW009", "demo/CMakeLists.txt:3"), ("RW012", "demo/rest.cmake")]
    followed = discover([tmp_path / "ws"], follow_links=True)
    assert names(followed) == ["demo/scripts/other", "demo/scripts/talk"]


def test_folders_that_are_marked_to_be_ignored_are_told(tmp_path: Path) -> None:
    write(tmp_path, {"attic/COLCON_IGNORE": "", "attic/a.py": "", "old/AMENT_IGNORE": "", "old/b.py": "", "c.py": ""})
    found = discover([tmp_path])
    assert names(found) == ["c.py"]
    message = "2 folders are marked as ignored (COLCON_IGNORE or similar): attic, old."
    assert [(f.code, f.message) for f in found.findings] == [("RW013", message)]


def test_build_output_with_the_mark_is_not_told(tmp_path: Path) -> None:
    write(tmp_path, {"src/a.py": "", "build/COLCON_IGNORE": "", "install/COLCON_IGNORE": "", "log/COLCON_IGNORE": ""})
    assert codes(discover([tmp_path])) == []


def test_a_launch_file_that_is_named_and_lies_in_an_ignored_folder_is_told(tmp_path: Path) -> None:
    write(
        tmp_path, {"attic/COLCON_IGNORE": "", "attic/launch/old.launch.py": "def generate_launch_description(): pass"}
    )
    found = discover([tmp_path], launch_files=[tmp_path / "attic/launch/old.launch.py"])
    assert codes(found) == [("RW013", ""), ("RW015", "attic/launch/old.launch.py")]


def test_two_packages_of_one_name_are_told(tmp_path: Path) -> None:
    write(tmp_path, {f"left/{name}": text for name, text in python_package("demo", "talker").items()})
    write(tmp_path, {f"right/{name}": text for name, text in python_package("demo", "talker").items()})
    found = discover([tmp_path])
    assert [(f.code, f.message) for f in found.findings] == [
        ("RW014", "2 packages are named demo: left/demo, right/demo.")
    ]


def test_things_named_like_python_files_are_told(tmp_path: Path) -> None:
    write(tmp_path, {"folder.py/inner.py": "", "good.py": ""})
    os.mkfifo(tmp_path / "pipe.py")
    (tmp_path / "broken.py").symlink_to("nowhere")
    (tmp_path / "device.py").symlink_to("/dev/zero")
    assert ("RW012", "device.py") in codes(discover([tmp_path]))
    found = discover([tmp_path], follow_links=True)
    assert names(found) == ["folder.py/inner.py", "good.py"]
    assert codes(found) == [
        ("RW002", "broken.py"),
        ("RW002", "device.py"),
        ("RW002", "folder.py"),
        ("RW002", "pipe.py"),
    ]


def test_descriptions_that_are_pipes_do_not_block(tmp_path: Path) -> None:
    write(tmp_path, {"demo/a.py": ""})
    for name in ("package.xml", "CMakeLists.txt", "setup.cfg", "pyproject.toml", "setup.py"):
        os.mkfifo(tmp_path / "demo" / name)
    found = discover([tmp_path])
    assert names(found) == ["demo/a.py"]
    assert {code for code, _ in codes(found)} == {"RW008", "RW017", "RW002"}


def test_a_very_deep_tree_is_walked(tmp_path: Path) -> None:
    deep = tmp_path
    while len(str(deep)) < 3900:
        deep = deep / ("d" * 40)
    deep.mkdir(parents=True)
    (deep / "a.py").write_text("")
    assert len(discover([tmp_path]).files) == 1


def test_a_name_that_is_no_text(tmp_path: Path) -> None:
    path = os.fsencode(tmp_path) + b"/n\xffme.py"
    try:
        with open(path, "w"):  # noqa: PTH123
            pass
    except OSError:
        pytest.skip("this file system has names of text only")
    assert names(discover([tmp_path])) == ["n\\xffme.py"]


def test_the_order_does_not_depend_on_the_file_system(tmp_path: Path) -> None:
    order = ["b.py", "a/z.py", "a.py", "a-b.py", "B.py"]
    assert names(read(tmp_path, dict.fromkeys(order, ""))) == sorted(order)
