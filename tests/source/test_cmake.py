# SPDX-License-Identifier: Apache-2.0
"""Promise: the scripts that CMake would install are found without CMake, whatever the description looks like."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from rosward.source.cmake.installed import CMakeProject, read_cmake
from rosward.source.cmake.text import parse_cmake
from source.trees import write

FILES = {"scripts/a.py": "", "scripts/b.py": "", "scripts/deep/c.py": "", "scripts/d.txt": ""}


def project(tmp_path: Path, text: str | bytes, **more: str) -> CMakeProject:
    write(tmp_path, {**FILES, "CMakeLists.txt": text, **more})
    return read_cmake(str(tmp_path), "demo", tmp_path)


def scripts(tmp_path: Path, result: CMakeProject) -> list[str]:
    return [f"{script.name} {Path(script.path).relative_to(tmp_path)}" for script in result.scripts]


@pytest.mark.parametrize(
    "text",
    [
        "install(PROGRAMS scripts/a.py DESTINATION lib/${PROJECT_NAME})",
        "INSTALL(PROGRAMS\n  # scripts/b.py\n  scripts/a.py #[[ b ]]\n  DESTINATION lib/demo/)",
        'install(PROGRAMS "scripts/a.py" DESTINATION "lib/${PROJECT_NAME}")',
        "install(PROGRAMS [[scripts/a.py]] DESTINATION [==[lib/demo]==])",
        "install(PROGRAMS ${CMAKE_CURRENT_SOURCE_DIR}/scripts/a.py DESTINATION ${CMAKE_INSTALL_LIBDIR}/demo)",
        "install(PROGRAMS scripts/a.py DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/demo COMPONENT x OPTIONAL)",
        "set(S scripts/a.py)\ninstall(PROGRAMS ${S} DESTINATION lib/demo)",
        "set(D lib/${PROJECT_NAME} CACHE STRING doc)\ninstall(PROGRAMS scripts/a.py DESTINATION ${D})",
        "list(APPEND S scripts/b.py)\nlist(APPEND S scripts/a.py)\nlist(REMOVE_ITEM S scripts/b.py)\n"
        "install(PROGRAMS ${S} DESTINATION lib/demo)",
        "set(V S)\nset(S scripts/a.py)\ninstall(PROGRAMS ${${V}} DESTINATION lib/demo)",
        "foreach(s a)\ninstall(PROGRAMS scripts/${s}.py DESTINATION lib/demo)\nendforeach()",
        "set(L a)\nforeach(s IN LISTS L)\ninstall(PROGRAMS scripts/${s}.py DESTINATION lib/demo)\nendforeach(s)",
        "foreach(s IN ITEMS a)\ninstall(PROGRAMS scripts/${s}.py DESTINATION lib/demo)\nendforeach()",
        "file(GLOB S scripts/a*.py)\ninstall(PROGRAMS ${S} DESTINATION lib/demo)",
        "file(GLOB S RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS s*/a.*)\n"
        "install(PROGRAMS ${S} DESTINATION lib/demo)",
        "function(put)\ninstall(PROGRAMS ${ARGN} DESTINATION lib/demo)\nendfunction()\nput(scripts/a.py)",
        "macro(put what)\ninstall(PROGRAMS ${what} DESTINATION lib/demo)\nendmacro()\nput(scripts/a.py)",
        "if(SOMETHING)\ninstall(PROGRAMS scripts/a.py DESTINATION lib/demo)\nelse()\nendif()",
        "project(other)\ninstall(PROGRAMS scripts/a.py DESTINATION lib/demo)",
        "install(FILES scripts/a.py DESTINATION lib/demo PERMISSIONS OWNER_EXECUTE OWNER_READ)",
        "get_filename_component(N x/a.txt NAME_WE)\ninstall(PROGRAMS scripts/${N}.py DESTINATION lib/demo)",
    ],
)
def test_ways_to_install_a_script(tmp_path: Path, text: str) -> None:
    result = project(tmp_path, text)
    assert scripts(tmp_path, result) == ["a.py scripts/a.py"]
    assert result.findings == ()


@pytest.mark.parametrize(
    "text",
    [
        "install(PROGRAMS scripts/a.py DESTINATION share/${PROJECT_NAME})",
        "install(PROGRAMS scripts/a.py DESTINATION bin)",
        "install(PROGRAMS scripts/a.py DESTINATION lib/demonstration)",
        "install(FILES scripts/a.py DESTINATION lib/demo)",
        "install(DIRECTORY scripts DESTINATION lib/demo)",
        "install(TARGETS talker DESTINATION lib/demo)",
        "# install(PROGRAMS scripts/a.py DESTINATION lib/demo)",
        "install()",
        "",
    ],
)
def test_what_is_no_executable(tmp_path: Path, text: str) -> None:
    assert project(tmp_path, text).scripts == ()


def test_rename(tmp_path: Path) -> None:
    result = project(tmp_path, "install(PROGRAMS scripts/a.py DESTINATION lib/demo RENAME talker)")
    assert scripts(tmp_path, result) == ["talker scripts/a.py"]
    assert str(result.scripts[0].place) == "CMakeLists.txt:1"


def test_recursive_glob(tmp_path: Path) -> None:
    result = project(tmp_path, "file(GLOB_RECURSE S scripts/*.py)\ninstall(PROGRAMS ${S} DESTINATION lib/demo)")
    assert scripts(tmp_path, result) == ["a.py scripts/a.py", "b.py scripts/b.py", "c.py scripts/deep/c.py"]


def test_folders_with_their_permissions(tmp_path: Path) -> None:
    text = "install(DIRECTORY scripts/ DESTINATION lib/demo USE_SOURCE_PERMISSIONS FILES_MATCHING PATTERN *.py)"
    write(tmp_path, FILES)
    (tmp_path / "scripts" / "b.py").chmod(0o755)
    (tmp_path / "scripts" / "d.txt").chmod(0o755)
    assert scripts(tmp_path, project(tmp_path, text)) == ["b.py scripts/b.py"]


def test_included_folders_and_files(tmp_path: Path) -> None:
    result = project(
        tmp_path,
        "add_subdirectory(scripts)\ninclude(cmake/more.cmake)\nadd_subdirectory(gone)\ninclude(GNUInstallDirs)",
        **{
            "scripts/CMakeLists.txt": "install(PROGRAMS a.py DESTINATION lib/${PROJECT_NAME})",
            "cmake/more.cmake": "install(PROGRAMS ${CMAKE_SOURCE_DIR}/scripts/b.py DESTINATION lib/demo)",
        },
    )
    assert scripts(tmp_path, result) == ["a.py scripts/a.py", "b.py scripts/b.py"]
    assert str(result.scripts[0].place) == "scripts/CMakeLists.txt:1"


def test_python_packages(tmp_path: Path) -> None:
    text = "ament_python_install_package(${PROJECT_NAME})\nament_python_install_package(demo PACKAGE_DIR src/lib/demo)"
    assert project(tmp_path, text).python_roots == (str(tmp_path), str(tmp_path / "src" / "lib"))


SCRIPTS = "[options.entry_points]\nconsole_scripts =\n    talker = demo.talker:main\n"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("ament_python_install_package(demo SCRIPTS_DESTINATION lib/${PROJECT_NAME})", ["talker"]),
        ("ament_python_install_package(demo PACKAGE_DIR src/demo SCRIPTS_DESTINATION lib/demo)", ["driver"]),
        ("ament_python_install_package(demo SETUP_CFG src/demo/setup.cfg SCRIPTS_DESTINATION lib/demo)", ["driver"]),
        ("ament_python_install_package(demo)", []),
        ("ament_python_install_package(demo SCRIPTS_DESTINATION)", []),
        ("ament_python_install_package(gone SCRIPTS_DESTINATION lib/demo)", []),
        ("ament_python_install_package(demo SETUP_CFG ../../etc/setup.cfg SCRIPTS_DESTINATION lib/demo)", []),
    ],
)
def test_scripts_of_a_python_package_within(tmp_path: Path, text: str, found: list[str]) -> None:
    """ament_cmake_python installs what the setup.cfg in the folder of the module declares, where it is told a destination."""
    driver = SCRIPTS.replace("talker", "driver")
    result = project(tmp_path, text, **{"demo/setup.cfg": SCRIPTS, "src/demo/setup.cfg": driver})
    assert [entry.name for entry in result.entry_points] == found


def test_a_program_outside_is_told_and_not_read(tmp_path: Path) -> None:
    result = project(tmp_path, "install(PROGRAMS ../../etc/passwd /etc/passwd DESTINATION lib/demo)")
    assert result.scripts == ()
    assert [(f.code, f.place.line) for f in result.findings] == [("RW008", 1), ("RW008", 1)]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("\ninstall(PROGRAMS a", 2),
        ('set(X "abc', 1),
        ("a\nb()", 2),
        (")", 1),
        ("set(A 1)\nfoo", 2),
        ("set(A 1))\n", 1),
        ("\n\\", 2),
        ("[[", 1),
        ("(((", 1),
    ],
)
def test_broken_text_is_told_with_its_line(tmp_path: Path, text: str, line: int) -> None:
    assert [(f.code, f.place.line) for f in project(tmp_path, text).findings] == [("RW008", line)]


def test_what_stands_before_the_break_counts(tmp_path: Path) -> None:
    result = project(tmp_path, "install(PROGRAMS scripts/a.py DESTINATION lib/demo)\nset(X ")
    assert scripts(tmp_path, result) == ["a.py scripts/a.py"]


@pytest.mark.parametrize(
    "text",
    [
        "set(X a)\n" + "set(X ${X}${X}${X}${X})\n" * 50,
        "set(X a)\n" + "list(APPEND X ${X} ${X})\n" * 50,
        "function(f)\nf()\nf()\nendfunction()\nf()",
        "foreach(a RANGE 9999)\nforeach(b RANGE 9999)\nset(x ${a})\nendforeach()\nendforeach()",
        "foreach(a RANGE)\nendforeach()\nforeach()\nendforeach()",
        "set(A ${A})\nset(A \\${A})\nset(B ${${${${B}}}})",
        "include(CMakeLists.txt)\nadd_subdirectory(.)\ninclude(x.cmake)",
        "[[" * 200_000,
        "set(" + "(" * 200_000,
        'set(X "' + '\\"' * 200_000 + '")',
        "file(GLOB_RECURSE X /*)\nfile(GLOB_RECURSE Y ../../../*)\nfile(GLOB Z [)",
        b"\xff\xfe\0",
        "endforeach()\nendfunction()\nforeach(x a b c)\n",
        "foreach(x a b)\n" * 3000,
        "set(PROJECT_NAME)\ninstall(PROGRAMS)\ninstall(PROGRAMS DESTINATION)\ninstall(PROGRAMS a RENAME)",
    ],
)
def test_descriptions_that_would_not_end(tmp_path: Path, text: str | bytes) -> None:
    start = time.process_time()
    project(tmp_path, text, **{"x.cmake": "include(x.cmake)\ninclude(x.cmake)"})
    assert time.process_time() - start < 10


def test_arguments_are_kept_as_written() -> None:
    commands, problem = parse_cmake('set(A "a;b" c\\ d ${E} [=[ ]] ]=] (x) -DFOO="b c")')
    assert problem is None
    assert [a.text for a in commands[0].arguments] == [
        "A",
        "a;b",
        "c\\ d",
        "${E}",
        " ]] ",
        "(",
        "x",
        ")",
        '-DFOO="b c"',
    ]
