# SPDX-License-Identifier: Apache-2.0
"""Promise: what a package builds in C++ is known without CMake: its programs, their sources over all packages, and how these are compiled."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from sampling import sample

from rosward.source.cmake.build import read_build
from rosward.source.cmake.compile_commands import read_compile_commands
from rosward.source.cmake.conditions import truth
from rosward.source.cmake.generators import Meant, meant
from rosward.source.cmake.installed import read_cmake
from rosward.source.cmake.programs import Builds, Program, Unit
from rosward.source.cmake.targets import Build, Definition
from source.trees import manifest, read, write

FILES = {"src/a.cpp": "", "src/b.cpp": "", "src/main.cpp": "", "src/deep/c.cc": "", "include/demo/a.hpp": ""}


def built(tmp_path: Path, text: str, **more: str) -> Build:
    write(tmp_path, {**FILES, "CMakeLists.txt": text, **more})
    return read_build(str(tmp_path), "demo", tmp_path, depends=("rclcpp", "std_msgs"), environment={"ROS_VERSION": "2"})


def sources(tmp_path: Path, build: Build, name: str) -> list[str]:
    return [Path(source).relative_to(tmp_path).as_posix() for source in build.targets[name].sources]


@pytest.mark.parametrize(
    "text",
    [
        "add_executable(talker src/a.cpp src/b.cpp)",
        "add_executable(talker src/a.cpp)\ntarget_sources(talker PRIVATE src/b.cpp)",
        "set(S src/a.cpp)\nlist(APPEND S src/b.cpp)\nadd_executable(${N}talker ${S})",
        "file(GLOB S src/[ab].cpp)\nadd_executable(talker ${S} include/demo/a.hpp)",
        "file(GLOB_RECURSE S CONFIGURE_DEPENDS src/*.cpp)\nlist(FILTER S EXCLUDE REGEX main)\nadd_executable(talker ${S})",
        "file(GLOB_RECURSE S src/*.cpp)\nlist(FILTER S EXCLUDE REGEX \".*/ma.*\")\nadd_executable(talker ${S})",
        "project(d VERSION 2.1)\nif(PROJECT_VERSION_MAJOR EQUAL 2 AND d_VERSION_MINOR EQUAL 1)\nadd_executable(talker src/a.cpp src/b.cpp)\nendif()",
        "foreach(s a b)\nlist(APPEND S src/${s}.cpp)\nendforeach()\nadd_executable(talker ${S})",
        "function(program name)\nadd_executable(${name} ${ARGN})\nendfunction()\nprogram(talker src/a.cpp src/b.cpp)",
        "macro(put)\nset(S src/a.cpp src/b.cpp)\nendmacro()\nput()\nadd_executable(talker ${S})",
        "function(put)\nset(S src/a.cpp src/b.cpp PARENT_SCOPE)\nendfunction()\nput()\nadd_executable(talker ${S})",
        "function(p)\ncmake_parse_arguments(ARG \"X\" \"NAME\" \"SOURCES\" ${ARGN})\nadd_executable(${ARG_NAME} ${ARG_SOURCES})\n"
        "endfunction()\np(NAME talker SOURCES src/a.cpp src/b.cpp)",
        "option(ALL \"x\" ON)\nif(ALL)\nadd_executable(talker src/a.cpp src/b.cpp)\nelse()\nadd_executable(talker src/main.cpp)\nendif()",
        "if(WIN32 OR NOT UNIX)\nadd_executable(talker src/main.cpp)\nelseif(1)\nadd_executable(talker src/a.cpp src/b.cpp)\nendif()",
        "set(i 0)\nwhile(i LESS 2)\nlist(GET L ${i} s)\nmath(EXPR i \"${i} + 1\")\nendwhile()\nadd_executable(talker src/a.cpp src/b.cpp)",
        "add_subdirectory(src)",
        "add_executable(talker src/a src/b)",
        "add_library(core OBJECT src/b.cpp)\nadd_executable(talker src/a.cpp src/b.cpp $<TARGET_OBJECTS:core>)",
        "ament_auto_add_executable(talker src/a.cpp src/b.cpp)",
        "if(BUILD_TESTING)\nadd_executable(talker src/main.cpp)\nendif()\nadd_executable(talker src/a.cpp src/b.cpp)",
        "if(FALSE)\nreturn()\nendif()\nadd_executable(talker src/a.cpp src/b.cpp)\nreturn()\nadd_executable(x src/a.cpp)",
    ],
)  # fmt: skip
def test_ways_to_make_a_program(tmp_path: Path, text: str) -> None:
    build = built(tmp_path, text, **{"src/CMakeLists.txt": "add_executable(talker a.cpp b.cpp)"})
    assert list(build.targets)[-1:] == ["talker"]
    assert sources(tmp_path, build, "talker") == ["src/a.cpp", "src/b.cpp"]
    assert build.targets["talker"].sure
    assert build.findings == ()


def test_what_nobody_decides_is_taken_both_ways_and_told(tmp_path: Path) -> None:
    build = built(
        tmp_path,
        "find_package(Magic)\nset(S src/a.cpp)\nif(Magic_FOUND)\nlist(APPEND S src/b.cpp)\nadd_definitions(-DMAGIC)\n"
        "add_executable(extra src/main.cpp)\nendif()\nadd_executable(talker ${S})",
    )
    assert sources(tmp_path, build, "talker") == ["src/a.cpp", "src/b.cpp"]
    assert [(t.name, t.sure) for t in build.targets.values()] == [("extra", False), ("talker", True)]
    assert build.targets["talker"].own.definitions == (Definition("MAGIC", "1", sure=False),)
    assert [str(place) for place in build.undecided] == ["CMakeLists.txt:3"]


def test_a_variable_that_differs_decides_nothing_afterwards(tmp_path: Path) -> None:
    text = "if($ENV{HOME} STREQUAL x)\nset(FAST ON)\nendif()\nif(FAST)\nadd_executable(talker src/a.cpp)\nendif()"
    assert not built(tmp_path, text).targets["talker"].sure


def test_macros_of_a_command_line(tmp_path: Path) -> None:
    text = (
        "add_definitions(-DA -DB=2)\nadd_compile_definitions(C=\"x\")\nadd_executable(talker src/a.cpp)\n"
        "target_compile_definitions(talker PRIVATE SIDE=\"left\" $<$<CONFIG:Debug>:TRACE>)\ntarget_compile_options(talker PRIVATE -Wall -DE=1)\n"
        'set_target_properties(talker PROPERTIES COMPILE_FLAGS "-O2 -DF")'
    )  # fmt: skip
    definitions = built(tmp_path, text).targets["talker"].own.definitions
    shown = sorted(f"{d.name}={d.value}{'' if d.sure else '?'}" for d in definitions)
    assert shown == ["A=1", "B=2", 'C="x"', "E=1", "F=1", 'SIDE="left"', "TRACE=1?"]


def test_components(tmp_path: Path) -> None:
    build = built(
        tmp_path,
        'add_library(arms SHARED src/a.cpp)\nrclcpp_components_register_node(arms PLUGIN "demo::Arm" EXECUTABLE arm EXECUTOR MultiThreadedExecutor)\n'
        'rclcpp_components_register_nodes(arms "demo::Left" "demo::Right")',
    )
    assert [(c.plugin, c.library, c.program, c.executor, c.place.line) for c in build.components] == [
        ("demo::Arm", "arms", "arm", "MultiThreadedExecutor", 2),
        ("demo::Left", "arms", "", "", 3),
        ("demo::Right", "arms", "", "", 3),
    ]


WORKSPACE = {
    "core/package.xml": manifest("core", "ament_cmake"),
    "core/CMakeLists.txt": "add_library(core src/core.cpp)\ntarget_compile_definitions(core PUBLIC CORE PRIVATE OWN)\n"
    "target_include_directories(core PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include/core>)\n"
    "install(DIRECTORY include/ DESTINATION include/${PROJECT_NAME})",
    "core/src/core.cpp": "",
    "core/include/core/core.hpp": "",
    "core/cmake/program.cmake": "macro(demo_program name)\nadd_executable(${name} ${ARGN})\n"
    "install(TARGETS ${name} DESTINATION lib/${PROJECT_NAME})\nendmacro()",
    "demo/package.xml": manifest("demo", "ament_cmake", "<depend>core</depend>"),
    "demo/src/main.cpp": "",
    "demo/src/lost.cpp": "",
    "demo/src/nested/test/test_a.cpp": "",
}


@pytest.mark.parametrize(
    "link",
    [
        "ament_target_dependencies(talker core)",
        "target_link_libraries(talker core::core)",
        "target_link_libraries(talker PUBLIC ${core_TARGETS} rclcpp::rclcpp)",
        "add_library(mine INTERFACE)\ntarget_link_libraries(mine INTERFACE ${core_LIBRARIES})\ntarget_link_libraries(talker mine)",
    ],
)
def test_a_program_over_two_packages(tmp_path: Path, link: str) -> None:
    text = f"find_package(core REQUIRED)\ndemo_program(talker src/main.cpp)\n{link}"
    workspace = read(tmp_path, {**WORKSPACE, "demo/CMakeLists.txt": text})
    builds = Builds.of(workspace)
    (program,) = builds.programs("demo")
    assert program.installed
    assert [Path(unit.path).name for unit in program.units] == ["main.cpp", "core.cpp"]
    main, core = program.units
    assert str(tmp_path / "core" / "include") in main.includes
    assert [d.name for d in core.definitions] == ["CORE", "OWN"]
    assert "OWN" not in [d.name for d in main.definitions]
    assert [Path(p).name for p in builds.unbuilt("demo")] == ["lost.cpp"]


def test_one_source_in_two_programs(tmp_path: Path) -> None:
    """What differs in macros is another unit, what does not is the same."""
    text = (
        "add_library(shared src/b.cpp)\nforeach(side left right)\nadd_executable(${side} src/a.cpp)\n"
        'target_compile_definitions(${side} PRIVATE SIDE="${side}")\ntarget_link_libraries(${side} shared)\nendforeach()'
    )
    files = {**FILES, "package.xml": manifest("demo", "ament_cmake"), "CMakeLists.txt": text}
    left, right = Builds.of(read(tmp_path, files)).programs("demo")
    units: set[Unit] = {*left.units, *right.units}
    assert sorted(Path(unit.path).name for unit in units) == ["a.cpp", "a.cpp", "b.cpp"]


@pytest.mark.parametrize("where", ["compile_commands.json", "build/demo/compile_commands.json"])
def test_what_a_build_has_left_says_more_than_the_description(tmp_path: Path, where: str) -> None:
    command = f'c++ -DSIDE=\\"left\\" -D "A=1 2" -DB -UB -Iinc -isystem /x -o CMakeFiles/talker.dir/src/a.cpp.o -c {tmp_path}/src/a.cpp'
    entry = {"directory": str(tmp_path), "command": command, "file": f"{tmp_path}/src/a.cpp"}
    files = {**FILES, "package.xml": manifest("demo", "ament_cmake"), where: json.dumps([entry, 1, {}, {"file": 2}])}
    text = "add_executable(talker src/a.cpp)\ntarget_compile_definitions(talker PRIVATE OTHER)\nadd_executable(other src/a.cpp)"
    talker, other = Builds.of(read(tmp_path, {**files, "CMakeLists.txt": text})).programs("demo")
    assert [(d.name, d.value) for d in talker.units[0].definitions] == [("SIDE", '"left"'), ("A", "1 2")]
    assert talker.units[0].includes[-2:] == (str(tmp_path / "inc"), "/x")
    assert other.units[0].definitions == ()


@pytest.mark.parametrize("text", ["", "[", "{}", "[" * 100_000, '[{"file": "a", "command": "' + "'" * 50_001 + '"}]'])
def test_broken_compile_commands_say_nothing(tmp_path: Path, text: str) -> None:
    write(tmp_path, {"compile_commands.json": text})
    assert all(not compiled.definitions for compiled in read_compile_commands([str(tmp_path)]).values())


def test_a_program_has_the_name_of_its_file(tmp_path: Path) -> None:
    text = "add_executable(talker_node src/a.cpp)\nset_target_properties(talker_node PROPERTIES OUTPUT_NAME talker)"
    files = {**FILES, "package.xml": manifest("demo", "ament_cmake"), "CMakeLists.txt": text}
    (program,) = Builds.of(read(tmp_path, files)).programs("demo")
    assert program.name == "talker"


@pytest.mark.parametrize(
    ("words", "installed"),
    [
        ("DESTINATION lib/demo", True),
        ("EXPORT x RUNTIME DESTINATION lib/${PROJECT_NAME}/ COMPONENT y", True),
        ("RUNTIME DESTINATION lib/demo PUBLIC_HEADER DESTINATION include", True),
        ("DESTINATION lib/demo EXCLUDE_FROM_ALL", True),
        ("LIBRARY DESTINATION lib/demo RUNTIME DESTINATION bin", False),
        ("PUBLIC_HEADER DESTINATION lib/demo", False),
        ("DESTINATION lib/demonstration", False),
    ],
)
def test_which_programs_are_installed(tmp_path: Path, words: str, installed: bool) -> None:
    """Whoever asks what can be started, and whoever asks what is built, are told the same."""
    build = built(tmp_path, f"add_executable(talker src/a.cpp)\ninstall(TARGETS talker {words})")
    assert build.targets["talker"].installed is installed
    assert bool(read_cmake(str(tmp_path), "demo", tmp_path).targets) is installed


def test_libraries_in_a_circle(tmp_path: Path) -> None:
    text = (
        "add_library(a src/a.cpp)\nadd_library(b src/b.cpp)\ntarget_link_libraries(a b)\ntarget_link_libraries(b a)\n"
        "add_executable(t src/main.cpp)\ntarget_link_libraries(t a)"
    )
    files = {**FILES, "package.xml": manifest("demo", "ament_cmake"), "CMakeLists.txt": text}
    (program,) = Builds.of(read(tmp_path, files)).programs("demo")
    assert isinstance(program, Program)
    assert [Path(unit.path).name for unit in program.units] == ["main.cpp", "a.cpp", "b.cpp"]


def test_sources_that_the_build_makes_are_missing(tmp_path: Path) -> None:
    text = "add_executable(talker src/a.cpp ${CMAKE_CURRENT_BINARY_DIR}/made.cpp src/gone.cpp ../../etc/x.cpp)"
    target = built(tmp_path, text).targets["talker"]
    assert target.missing == ("*/made.cpp", "src/gone.cpp", "../../etc/x.cpp")


@pytest.mark.parametrize(
    ("path", "names"),
    [
        ("esw/fw/lib", ["bridge"]),  # of a submodule that was not fetched
        ("esw/fw", ["bridge"]),
        ("esw/here/lib", ["bridge"]),
        ("esw/here/gone", []),
        ("esw/fwd/lib", []),
    ],
)
def test_what_is_in_a_submodule_that_is_not_there_is_not_known(tmp_path: Path, path: str, names: list[str]) -> None:
    modules = '[submodule "fw"]\n\tpath = esw/fw\n\turl = x\n[submodule "here"]\n\tpath = esw/here\n'
    text = f"if(EXISTS ${{CMAKE_CURRENT_SOURCE_DIR}}/{path} AND NOT APPLE)\nadd_executable(bridge src/a.cpp)\nendif()"
    build = built(tmp_path, text, **{".gitmodules": modules, "esw/here/lib/a.c": ""})
    assert [*build.targets] == names


@pytest.mark.parametrize(
    ("condition", "taken"),
    [
        ("1 AND NOT 0", "yes"),
        ("NOT (ON AND (OFF OR N))", "yes"),
        ("A STREQUAL x AND DEFINED A", "yes"),
        ("x IN_LIST L", "yes"),
        ("B", "no"),
        ("NOT DEFINED B", "yes"),
        ("3.10 VERSION_GREATER 3.9", "yes"),
        ("TARGET t", "yes"),
        ("TARGET other", "no"),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/src/a.cpp", "yes"),
        ("EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/src/z.cpp", "no"),
        ("EXISTS /etc/passwd", "both"),
        ("CMAKE_BUILD_TYPE STREQUAL Debug", "both"),
        ("CMAKE_BUILD_TYPE STREQUAL Debug AND 0", "no"),
        ("CMAKE_BUILD_TYPE STREQUAL Debug OR 1", "yes"),
        ("$ENV{ROS_DISTRO} STREQUAL humble", "both"),
        ("$ENV{ROS_VERSION} EQUAL 2", "yes"),
        ("DEFINED ENV{ROS_VERSION}", "yes"),
        ("DEFINED ENV{CMAKE_PREFIX_PATH}", "both"),
        ("DEFINED ENV{USE_SIMULATOR} AND \"$ENV{USE_SIMULATOR}\" STREQUAL \"1\"", "no"),
        ("\"$ENV{USE_SIMULATOR}\" STREQUAL \"\"", "yes"),
        ("$ENV{USE_SIMULATOR}", "no"),
        ("${NOWHERE_SET}", "no"),
        ("A MATCHES \"(a+)+b\"", "both"),
        ("A MATCHES \"[[x]\"", "both"),
        ("A B C (", "both"),
        ("((((((((((((((((((((((((((((((((((((((1", "both"),
    ],
)  # fmt: skip
def test_conditions(tmp_path: Path, condition: str, taken: str) -> None:
    text = "set(A x)\nset(L a x)\nadd_library(t src/a.cpp)\n"
    text += f"if({condition})\nset(R yes)\nelse()\nset(R no)\nendif()\nadd_executable(${{R}} src/a.cpp)"
    if condition.count("(") != condition.count(")"):
        text = text.replace(f"if({condition})", f'if("{condition}" STREQUAL "$ENV{{HOME}}")')
    names = [name for name in built(tmp_path, text).targets if name != "t"]
    assert names == {"yes": ["yes"], "no": ["no"], "both": ["yes"]}[taken] or taken == "both"
    assert len(built(tmp_path, text).undecided) == (taken == "both")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a", Meant("a")),
        ("$<BUILD_INTERFACE:/x/include>", Meant("/x/include")),
        ("$<INSTALL_INTERFACE:include>", Meant("")),
        ("$<$<CONFIG:Debug>:T=a:b>", Meant("T=a:b", sure=False)),
        ("$<TARGET_OBJECTS:core>", Meant("$<TARGET_OBJECTS:core>")),
        ("$<BUILD_INTERFACE:$<BUILD_INTERFACE:x>>/y", Meant("x/y")),
        ("$<", Meant("", sure=False)),
        ("$<" * 5000, Meant("", sure=False)),
    ],
)
def test_generator_expressions(text: str, expected: Meant) -> None:
    assert meant(text) == expected


def test_constants() -> None:
    assert [truth(t) for t in ("on", "Off", "x-NOTFOUND", "0.0", "2", "abc", "")] == [
        True,
        False,
        False,
        False,
        True,
        None,
        False,
    ]


@pytest.mark.parametrize(
    "text",
    sample([
        "while(1)\nset(X ${X}x)\nendwhile()",
        "while(UNDEFINED_X OR $ENV{HOME})\nendwhile()",
        "function(f)\nset(X ${X};${X} PARENT_SCOPE)\nf()\nendfunction()\nf()",
        "macro(f)\nf()\nf()\nendmacro()\nf()",
        "if($ENV{HOME})\n" * 3000,
        "set(X a)\n" + "if($ENV{HOME})\nset(X ${X}${X})\nendif()\n" * 3000,
        "".join(f"set(V{i} x)\n" for i in range(3000)) + "if($ENV{HOME})\nendif()\n" * 3000,
        "foreach(i RANGE 9999)\nadd_executable(t${i} src/a.cpp)\ntarget_link_libraries(t${i} t0)\nendforeach()",
        "string(REGEX REPLACE \"(a*)*b\" x Y " + "a" * 5000 + ")\nstring(REPLACE a " + "b" * 500 + " Y " + "a" * 5000 + ")",
        "list(TRANSFORM X APPEND y)\nlist(SUBLIST X)\nlist(GET X 5 Y)\nlist(INSERT X a b)\nlist(REMOVE_AT X 1)",
        "add_library(a ALIAS b)\nadd_library(b ALIAS a)\ntarget_link_libraries(a b)\nrclcpp_components_register_node(a PLUGIN x)",
        "if(" + "NOT " * 50_000 + "1)\nendif()\nif(" + "(" * 50_000,
    ], 3),
)  # fmt: skip
def test_builds_that_would_not_end(tmp_path: Path, text: str) -> None:
    build = built(tmp_path, text, **{"package.xml": manifest("demo", "ament_cmake")})
    workspace = Builds.of(read(tmp_path, {}))
    assert len(list(workspace.programs("demo"))) <= 2_000
    assert build.package == "demo"
