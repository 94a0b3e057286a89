# SPDX-License-Identifier: Apache-2.0
"""Which macros does the compiler define by the version of C++ that a build asks for?

    set(CMAKE_CXX_STANDARD 20), target_compile_features(talker PUBLIC cxx_std_20), -std=c++20     ->   __cplusplus=202002L, …

What nobody asks for is C++ 17, as GCC has it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final

from rosward.source.cmake.targets import Definition
from rosward.source.cmake.variables import HOLE

_VERSIONS: Final[Mapping[str, str]] = {
    "98": "199711L", "11": "201103L", "14": "201402L", "17": "201703L", "20": "202002L", "23": "202302L",
    "1y": "201402L", "1z": "201703L", "2a": "202002L", "2b": "202302L",
}  # fmt: skip
_NEWER: Final = "202002L"
_OF_NEWER: Final = (
    Definition("__cpp_concepts", "202002L"),
    Definition("__cpp_impl_coroutine", "201902L"),
    Definition("__cpp_lib_format", "202110L", sure=False),
    Definition("__cpp_lib_source_location", "201907L", sure=False),
)
"""What GCC defines from C++ 20 on; parts of its library came later than others."""
_OPTION: Final = re.compile(r"-std=(?:c|gnu)\+\+(\w\w)")
_FEATURE: Final = "cxx_std_"


def of_standard(standard: str, *, sure: bool = True) -> dict[Definition, None]:
    """The macros of a version as `CXX_STANDARD` names it; one that is not known may be a newer one than nobody asks for."""
    if HOLE in standard:
        standard, sure = "20", False
    version = _VERSIONS.get(standard, "")
    if not version:
        return {}
    others = _OF_NEWER if version >= _NEWER else ()
    return {each._replace(sure=each.sure and sure): None for each in (Definition("__cplusplus", version), *others)}


def of_options(options: Iterable[str], *, sure: bool = True) -> dict[Definition, None]:
    """Those of a version that an option of the compiler asks for; the last one counts."""
    found = [each for option in options for each in _OPTION.findall(option)]
    return of_standard(found[-1], sure=sure) if found else {}


def of_features(features: Iterable[str], *, sure: bool = True) -> dict[Definition, None]:
    """Those of a version that is needed at least."""
    found = [f.removeprefix(_FEATURE) for f in features if f.startswith(_FEATURE)]
    newer = [each for each in found if _VERSIONS.get(each, "") >= _NEWER]
    return of_standard(max(newer), sure=sure) if newer else {}
