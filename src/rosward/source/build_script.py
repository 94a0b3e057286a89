# SPDX-License-Identifier: Apache-2.0
"""Which setup.py describes a build, and which is a module of that name?"""

from __future__ import annotations

from rosward.source import limits
from rosward.source.text import read_bytes

__all__ = ["is_build_script"]


def is_build_script(path: str) -> bool:
    """Whether a file named `setup.py` describes a build, rather than being a module of that name."""
    data = read_bytes(path, path, limits.DESCRIPTION_FILE)
    return isinstance(data, bytes) and (b"setuptools" in data or b"distutils" in data or b"catkin_pkg" in data)
