# SPDX-License-Identifier: Apache-2.0
"""Promise: an import leads to the file that Python would load, and a guess says that it is one."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from rosward.source.discover import discover
from rosward.source.imports import ImportResolver, ImportTarget
from source.trees import file, manifest, python_package, read, setup, write


def resolve(tmp_path: Path, files: Mapping[str, str], importer: str, name: str) -> ImportTarget | None:
    workspace = read(tmp_path, files)
    level = len(name) - len(name.lstrip("."))
    return ImportResolver(workspace).resolve(name.lstrip("."), level, file(workspace, importer))


def target(found: ImportTarget | None) -> str | None:
    """The file, with `?` before it for a guess; a namespace package as its name with `/`."""
    if found is None:
        return None
    return ("?" if found.guess else "") + (found.file.relative if found.file is not None else f"{found.name}/")


DEMO = python_package("demo", "talker", "helper") | {
    "demo/demo/nodes/__init__.py": "",
    "demo/demo/nodes/deep.py": "",
    "demo/demo/plain/thing.py": "",
    "demo/scripts/run.py": "",
    "demo/scripts/tool.py": "",
}
OTHER = python_package("other", "main", "helper")


@pytest.mark.parametrize(
    ("importer", "name", "expected"),
    [
        ("demo/demo/talker.py", "demo", "demo/demo/__init__.py"),
        ("demo/demo/talker.py", "demo.helper", "demo/demo/helper.py"),
        ("demo/demo/talker.py", "demo.nodes", "demo/demo/nodes/__init__.py"),
        ("demo/demo/talker.py", "demo.nodes.deep", "demo/demo/nodes/deep.py"),
        ("demo/demo/talker.py", "demo.plain", "demo.plain/"),
        ("demo/demo/talker.py", "demo.plain.thing", "demo/demo/plain/thing.py"),
        ("demo/demo/talker.py", "demo.missing", None),
        ("demo/demo/talker.py", ".helper", "demo/demo/helper.py"),
        ("demo/demo/talker.py", ".", "demo/demo/__init__.py"),
        ("demo/demo/__init__.py", ".helper", "demo/demo/helper.py"),
        ("demo/demo/nodes/deep.py", "..helper", "demo/demo/helper.py"),
        ("demo/demo/nodes/deep.py", "..", "demo/demo/__init__.py"),
        ("demo/demo/nodes/deep.py", ".missing", None),
        ("demo/demo/plain/thing.py", "..nodes.deep", "demo/demo/nodes/deep.py"),
        ("demo/demo/talker.py", ".....x", None),
        ("demo/demo/talker.py", "other.helper", "other/other/helper.py"),
        ("demo/scripts/run.py", "tool", "demo/scripts/tool.py"),
        ("demo/scripts/run.py", "demo.helper", "demo/demo/helper.py"),
        ("demo/scripts/run.py", "other", "other/other/__init__.py"),
        ("demo/demo/talker.py", "helper", "?demo/demo/helper.py"),
        ("demo/demo/talker.py", "tool", "?demo/scripts/tool.py"),
        ("other/other/main.py", "tool", "?demo/scripts/tool.py"),
        ("demo/demo/talker.py", "thing", "?demo/demo/plain/thing.py"),
        ("demo/demo/talker.py", "plain.thing", "?demo/demo/plain/thing.py"),
        ("demo/demo/talker.py", "rclpy", None),
        ("demo/demo/talker.py", "std_msgs.msg", None),
        ("demo/demo/talker.py", "os.path", None),
    ],
)
def test_names(tmp_path: Path, importer: str, name: str, expected: str | None) -> None:
    assert target(resolve(tmp_path, DEMO | OTHER, importer, name)) == expected


def test_the_name_of_a_relative_import_is_whole(tmp_path: Path) -> None:
    found = resolve(tmp_path, DEMO, "demo/demo/nodes/deep.py", "..helper")
    assert found is not None
    assert (found.name, found.is_package) == ("demo.helper", False)


def test_the_name_of_a_relative_namespace_is_whole(tmp_path: Path) -> None:
    found = resolve(tmp_path, DEMO, "demo/demo/talker.py", ".plain")
    assert found is not None
    assert (found.name, found.file, found.is_package) == ("demo.plain", None, True)


def test_submodules(tmp_path: Path) -> None:
    workspace = read(tmp_path, DEMO)
    resolver = ImportResolver(workspace)
    package = resolver.resolve("demo", 0, file(workspace, "demo/demo/talker.py"))
    assert package is not None
    found = resolver.submodule(package, "nodes")
    assert found is not None
    assert (found.name, target(found)) == ("demo.nodes", "demo/demo/nodes/__init__.py")
    assert resolver.submodule(package, "nothing") is None
    helper = resolver.resolve("demo.helper", 0, file(workspace, "demo/demo/talker.py"))
    assert helper is not None
    assert helper.file is file(workspace, "demo/demo/helper.py")


def test_a_package_goes_before_a_module_of_its_name(tmp_path: Path) -> None:
    files = python_package("demo", "talker", "x") | {"demo/demo/x/__init__.py": ""}
    assert target(resolve(tmp_path, files, "demo/demo/talker.py", "demo.x")) == "demo/demo/x/__init__.py"


def test_a_module_goes_before_a_plain_folder_of_its_name(tmp_path: Path) -> None:
    files = python_package("demo", "talker", "x") | {"demo/demo/x/y.py": ""}
    assert target(resolve(tmp_path, files, "demo/demo/talker.py", "demo.x")) == "demo/demo/x.py"


def test_the_nearest_of_two_copies(tmp_path: Path) -> None:
    files = {f"{ws}/src/{n}": t for ws in ("ws1", "ws2") for n, t in (DEMO | OTHER).items()}
    found = resolve(tmp_path, files, "ws2/src/other/other/main.py", "demo.helper")
    assert target(found) == "ws2/src/demo/demo/helper.py"


def test_two_files_of_one_name_are_no_guess(tmp_path: Path) -> None:
    files = python_package("demo", "talker") | {"demo/a/tool.py": "", "demo/b/deep/tool.py": "", "c/tool.py": ""}
    found = resolve(tmp_path, files, "demo/demo/talker.py", "deep.tool")
    assert target(found) == "?demo/b/deep/tool.py"
    assert target(resolve(tmp_path, files, "demo/demo/talker.py", "x.tool")) is None


def test_a_script_finds_what_is_installed_beside_it(tmp_path: Path) -> None:
    files = {
        "package.xml": manifest("demo", "ament_cmake"),
        "CMakeLists.txt": "install(PROGRAMS a/run.py b/tool.py DESTINATION lib/demo)",
        "a/run.py": "",
        "b/tool.py": "",
    }
    assert target(resolve(tmp_path, files, "a/run.py", "tool")) == "b/tool.py"


def test_a_module_that_is_installed_as_a_script_finds_its_siblings(tmp_path: Path) -> None:
    files = {
        "package.xml": manifest("demo", "ament_cmake"),
        "CMakeLists.txt": "install(PROGRAMS demo/run.py demo/tool.py DESTINATION lib/${PROJECT_NAME})",
        **dict.fromkeys(["demo/__init__.py", "demo/run.py", "demo/tool.py"], ""),
    }
    assert target(resolve(tmp_path, files, "demo/run.py", "tool")) == "demo/tool.py"


def test_declared_folders_of_modules(tmp_path: Path) -> None:
    files = {
        "package.xml": manifest("demo"),
        "setup.py": setup("demo", more="package_dir={'': 'lib'},"),
        **dict.fromkeys(["lib/demo/__init__.py", "lib/demo/a.py", "lib/demo/b.py"], ""),
    }
    assert target(resolve(tmp_path, files, "lib/demo/a.py", "demo.b")) == "lib/demo/b.py"


def test_the_standard_library_is_never_guessed(tmp_path: Path) -> None:
    files = python_package("demo", "talker", "queue") | {"demo/scripts/signal.py": ""}
    assert resolve(tmp_path, files, "demo/demo/talker.py", "queue") is None
    assert resolve(tmp_path, files, "demo/demo/talker.py", "signal") is None


def test_a_scripts_own_folder_goes_before_the_standard_library(tmp_path: Path) -> None:
    files = {"run.py": "", "queue.py": "", "sys.py": ""}
    assert target(resolve(tmp_path, files, "run.py", "queue")) == "queue.py"
    assert resolve(tmp_path, files, "run.py", "sys") is None


def test_a_module_that_imports_its_own_name_means_another(tmp_path: Path) -> None:
    assert resolve(tmp_path, python_package("demo", "controller"), "demo/demo/controller.py", "controller") is None


def test_interfaces_are_no_modules(tmp_path: Path) -> None:
    files = python_package("demo", "talker") | {"demo/msg/Foo.msg": ""}
    assert resolve(tmp_path, files, "demo/demo/talker.py", "demo.msg") is None


def test_a_single_file_finds_what_is_around_it(tmp_path: Path) -> None:
    write(tmp_path, DEMO)
    workspace = discover([tmp_path / "demo" / "demo" / "talker.py"])
    resolver = ImportResolver(workspace)
    (talker,) = workspace.files
    assert target(resolver.resolve("demo.nodes.deep", 0, talker)) == "nodes/deep.py"
    assert target(resolver.resolve("helper", 1, talker)) == "helper.py"
    found = resolver.resolve("demo", 0, talker)
    assert found is not None
    assert found.file is not None
    assert (found.file.module, found.file.package) == ("demo", talker.package)


def test_a_single_file_without_package_finds_its_siblings(tmp_path: Path) -> None:
    write(tmp_path, {"a/run.py": "", "a/tool.py": "", "p/__init__.py": "", "p/q/__init__.py": "", "p/q/run.py": ""})
    workspace = discover([tmp_path / "a" / "run.py"])
    assert target(ImportResolver(workspace).resolve("tool", 0, workspace.files[0])) == "tool.py"
    workspace = discover([tmp_path / "p" / "q" / "run.py"])
    assert workspace.files[0].module == "p.q.run"
    assert target(ImportResolver(workspace).resolve("p", 0, workspace.files[0])) == "../__init__.py"


def test_each_file_has_one_record(tmp_path: Path) -> None:
    write(tmp_path, DEMO)
    workspace = discover([tmp_path / "demo" / "demo" / "talker.py"])
    resolver = ImportResolver(workspace)
    one = resolver.resolve("demo.helper", 0, workspace.files[0])
    two = resolver.resolve("helper", 1, workspace.files[0])
    assert one is not None
    assert two is not None
    assert one.file is two.file


def test_the_answer_does_not_depend_on_the_order_of_questions(tmp_path: Path) -> None:
    workspace = read(tmp_path, DEMO | OTHER)
    questions = [
        (name, file) for file in workspace.files for name in ("tool", "helper", "demo.helper", "other", "thing")
    ]
    forward, backward = ImportResolver(workspace), ImportResolver(workspace)
    answers = [target(forward.resolve(name, 0, file)) for name, file in questions]
    assert answers == [target(backward.resolve(name, 0, file)) for name, file in reversed(questions)][::-1]


@pytest.mark.parametrize("name", ["", ".", "..", "a..b", "demo.", "\0", "demo/talker", "../demo", "demo\n"])
def test_names_that_are_none(tmp_path: Path, name: str) -> None:
    workspace = read(tmp_path, DEMO)
    ImportResolver(workspace).resolve(name, 0, file(workspace, "demo/demo/talker.py"))
    ImportResolver(workspace).resolve(name, 2, file(workspace, "demo/demo/talker.py"))
