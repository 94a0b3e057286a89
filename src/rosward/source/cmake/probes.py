# SPDX-License-Identifier: Apache-2.0
"""Which variables does a command write with what nobody knows before the build?

check_include_files(linux/joystick.h HAVE_JOYSTICK)      HAVE_JOYSTICK
pkg_check_modules(USB libusb-1.0)                        USB_FOUND
find_library(PIGPIO NAMES pigpio)                        PIGPIO
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final

from rosward.source.cmake.conditions import truth
from rosward.source.cmake.variables import HOLE

__all__ = ["is_kept", "may_write", "written"]

_PLACES: Final = {
    "check_c_compiler_flag": 1, "check_c_source_compiles": 1, "check_c_source_runs": 1, "check_compiler_flag": 2,
    "check_cxx_compiler_flag": 1, "check_cxx_source_compiles": 1, "check_cxx_source_runs": 1,
    "check_cxx_symbol_exists": 2, "check_function_exists": 1, "check_include_file": 1, "check_include_file_cxx": 1,
    "check_include_files": 1, "check_ipo_supported": 1, "check_library_exists": 3, "check_linker_flag": 2,
    "check_prototype_definition": 4, "check_source_compiles": 2, "check_source_runs": 2, "check_struct_has_member": 3,
    "check_symbol_exists": 2, "check_variable_exists": 1, "cmake_host_system_information": 1,
    "find_file": 0, "find_library": 0, "find_path": 0, "find_program": 0, "get_cmake_property": 0, "get_property": 0,
    "get_target_property": 0, "math": 1, "pkg_get_variable": 0, "separate_arguments": 0, "site_name": 0,
    "test_big_endian": 0,
}  # fmt: skip
"""At which place commands of CMake and its modules name the variable."""
_OF_MODULES: Final = ("CFLAGS", "INCLUDE_DIRS", "LDFLAGS", "LIBRARIES", "LIBRARY_DIRS", "LINK_LIBRARIES", "VERSION")
_ASKS: Final = re.compile(r"(?:^|_)(?:check|detect|find|probe|query|search)(?:_|$)")


def written(name: str, arguments: Sequence[str]) -> dict[str, str] | None:
    """The variables that a command of CMake writes, with their values; None of a command that writes none, or that is another one."""
    if name in {"pkg_check_modules", "pkg_search_module"}:
        others = dict.fromkeys((f"{each}_{part}" for each in arguments[:1] for part in _OF_MODULES), HOLE)
        return others | {f"{each}_FOUND": "1" if "REQUIRED" in arguments else HOLE for each in arguments[:1]}
    names: Sequence[str] = ()
    if name in {"execute_process", "try_compile", "try_run"}:
        names = arguments
    elif name == "check_type_size":
        names = [*arguments[1:2], *(f"HAVE_{each}" for each in arguments[1:2])]
    elif name in _PLACES:
        names = arguments[_PLACES[name] : _PLACES[name] + 1]
    else:
        return None
    return dict.fromkeys((n for n in names if n.isidentifier()), HOLE)


def is_kept(name: str) -> bool:
    """Whether a command writes variables of the whole build (the cache), not of the function that it stands in."""
    return name.startswith(("check_", "find_", "pkg_", "try_", "test_"))


def may_write(name: str, arguments: Sequence[str], known: Mapping[str, str]) -> dict[str, str]:
    """Those that a command which nothing defines may write, by its name: `detect_sdk(HAVE_SDK)`; of `known` ones, what is false so far."""
    if not _ASKS.search(name):
        return {}
    return dict.fromkeys((a for a in arguments if a.isidentifier() and truth(known.get(a, "")) is False), HOLE)
