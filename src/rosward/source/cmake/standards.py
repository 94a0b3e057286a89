# SPDX-License-Identifier: Apache-2.0
"""Which macros does the compiler define by the version of C++ that a build asks for?

    set(CMAKE_CXX_STANDARD 20), target_compile_features(talker PUBLIC cxx_std_20), -std=c++20     ->   __cplusplus=202002L, …

What nobody asks for is C++ 17, as GCC has it. CMake writes the version that a target has behind all options, or a newer one that its
features need; features that the compiler has anyway say nothing.
"""

from __future__ import annotations

import enum
import itertools
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final

from rosward.records import NamedTuple
from rosward.source.cmake.variables import HOLE

_VERSIONS: Final[Mapping[str, str]] = {
    "98": "199711L", "11": "201103L", "14": "201402L", "17": "201703L", "20": "202002L", "23": "202302L", "26": "202302L",
    "1y": "201402L", "1z": "201703L", "2a": "202002L", "2b": "202302L", "2c": "202302L",
}  # fmt: skip
_USUAL: Final = "201703L"
_NEWER: Final = "202002L"
_OF_NEWER: Final = (
    ("__cpp_concepts", "202002L", True),
    ("__cpp_impl_coroutine", "201902L", True),
    ("__cpp_lib_format", "202110L", False),
    ("__cpp_lib_source_location", "201907L", False),
)
"""What GCC defines from C++ 20 on; parts of its library came later than others."""
_OPTION: Final = re.compile(r"-std=(?:c|gnu)\+\+(\w\w)")
_FEATURE: Final = "cxx_std_"


class By(enum.Enum):
    """How a version is asked for."""

    OPTION = "option"
    PROPERTY = "property"
    FEATURE = "feature"


class Standard(NamedTuple):
    """A version of C++, as `__cplusplus` says it, that something asks for; without `sure`, nobody knows whether it does."""

    by: By
    version: str
    sure: bool = True


def of_standard(standard: str, *, sure: bool = True) -> Iterator[Standard]:
    """What `CXX_STANDARD` asks for; one that is not known may be a newer one than nobody asks for."""
    if HOLE in standard:
        standard, sure = "20", False
    if standard in _VERSIONS:
        yield Standard(By.PROPERTY, _VERSIONS[standard], sure)


def of_options(options: Iterable[str], *, sure: bool = True) -> Iterator[Standard]:
    """What options of the compiler ask for."""
    for option in options:
        for found in _OPTION.findall(option):
            if found in _VERSIONS:
                yield Standard(By.OPTION, _VERSIONS[found], sure)


def of_features(features: Iterable[str], *, sure: bool = True) -> Iterator[Standard]:
    """What is needed at least."""
    for feature in features:
        if feature.removeprefix(_FEATURE) in _VERSIONS:
            yield Standard(By.FEATURE, _VERSIONS[feature.removeprefix(_FEATURE)], sure)


def macros(asked: Sequence[Standard]) -> Iterator[tuple[str, str, bool]]:
    """The macros of the version that comes of all that is asked for, in this order: name, value, whether it is sure.

    Of several versions each has a macro that is not sure, behind the one that is there otherwise.
    """
    if not asked:
        return
    told, written = (_last(each for each in asked if each.by is by) for by in (By.PROPERTY, By.OPTION))
    features = [each for each in asked if each.by is By.FEATURE]
    needed = {max((f.version for f in features if f.sure or unsure), default="") for unsure in (False, True)}
    versions = sorted({_version(*each) for each in itertools.product(told, needed, written)})
    if _USUAL in versions:
        versions.remove(_USUAL)
        yield from (("__cplusplus", version, False) for version in versions)
        sure = False
    else:
        yield from (("__cplusplus", version, not number) for number, version in enumerate(versions))
        sure = versions[0] >= _NEWER
    if versions and versions[-1] >= _NEWER:
        yield from ((name, value, known and sure) for name, value, known in _OF_NEWER)


def _last(asked: Iterable[Standard]) -> set[str]:
    """The last version that is asked for, and those behind it of which nobody knows; '' for none."""
    found = {""}
    for each in asked:
        found = {each.version} if each.sure else {*found, each.version}
    return found


def _version(told: str, needed: str, written: str) -> str:
    if told:
        return max(told, needed)
    return needed if needed > _USUAL else written or _USUAL
