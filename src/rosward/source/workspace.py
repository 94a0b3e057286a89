# SPDX-License-Identifier: Apache-2.0
"""What is there to read: files, packages and executables of an analysis, as plain records.

    Workspace(root="/ws", files=(talker.py, …), packages=(demo,), executables=(demo/talker -> demo.talker:main,), …)

`source/discover.py` fills them. Each file and each package has one record in an analysis; they are compared by
identity.
"""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import TYPE_CHECKING, Final, final

from rosward.records import NamedTuple, dataclass, field
from rosward.source.boundary import EVERYWHERE, Boundary
from rosward.source.exclude import Exclusions
from rosward.source.surroundings import ROS_2

if TYPE_CHECKING:
    from pathlib import Path

    from rosward.findings import Finding
    from rosward.location import Place


_NOTHING: Final = Exclusions()


class Shared(NamedTuple):
    """What the build puts below the share folder of a package: `target` (relative to it, `launch` or `config/a.yaml`) is the file or folder `source`.

    Of a folder that is not `whole`, only what fits a pattern is installed.
    """

    target: str
    source: str
    place: Place
    whole: bool = True


class GeneratedModule(NamedTuple):
    """A Python module `package.name` that the build makes of the parameters that the file `source` describes.

    `validation` is the module with validators of its own, '' where there is none.
    """

    package: str
    name: str
    source: str
    validation: str
    place: Place


@final
@dataclass(frozen=True, slots=True, eq=False)
class Package:
    """A folder with a `package.xml`, or, without one, with a `setup.py` (then `build_type` is `python`).

    `depends` are the packages that it names for building or running. `python_roots` are the folders from which, by its
    build description, its modules are imported. `shared` is what stands in its share folder once it is installed;
    without `all_shared`, the build description says more that cannot be told without running it. `generated` are the
    modules that the build makes.
    """

    name: str
    path: Path
    relative: str
    build_type: str
    depends: frozenset[str] = frozenset()
    python_roots: tuple[Path, ...] = ()
    shared: tuple[Shared, ...] = ()
    all_shared: bool = True
    generated: tuple[GeneratedModule, ...] = ()

    def __repr__(self) -> str:
        return f"<package {self.name} at {self.relative}>"


@final
@dataclass(frozen=True, slots=True, eq=False)
class SourceFile:
    """One file of source text, not yet read.

    `relative` is how places name it. `module` is the dotted name under which Python imports it (`None` for a file that
    no import can name: a script without suffix, a launch description).
    """

    path: Path
    relative: str
    package: Package | None = None
    module: str | None = None

    @property
    def is_package(self) -> bool:
        """Whether this is the `__init__.py` of a Python package."""
        return self.path.name == "__init__.py"

    def __repr__(self) -> str:
        return f"<file {self.relative}>"


class ExecutableKind(enum.Enum):
    """How an executable starts."""

    CONSOLE_SCRIPT = "console_script"
    """By calling a function of a module (`module`, `function`)."""

    SCRIPT = "script"
    """By running a file as `__main__`."""


@final
@dataclass(frozen=True, slots=True)
class Executable:
    """Something that `ros2 run PACKAGE NAME` starts; `file` is `None` where its source was not found."""

    package: Package
    name: str
    kind: ExecutableKind
    file: SourceFile | None
    place: Place
    module: str | None = None
    function: str | None = None


class TargetKind(enum.Enum):
    """What CMake builds."""

    EXECUTABLE = "executable"
    COMPONENT = "component"


@final
@dataclass(frozen=True, slots=True)
class Target:
    """A program or a component that CMake builds of `package`; its source is not Python.

    `name` is that of the executable, or of the library that has the component. `plugin` is the class of a component, also of an executable that
    is made of one by `rclcpp_components_register_node(… EXECUTABLE name)`.
    """

    package: Package
    name: str
    kind: TargetKind
    place: Place
    plugin: str = ""


class SkipReason(enum.Enum):
    """Why a folder or file was left out."""

    BUILD_OUTPUT = "build output"
    ENVIRONMENT = "virtual environment or installed packages"
    HIDDEN = "hidden"
    IGNORED = "marked as ignored (COLCON_IGNORE or similar)"
    TEST = "tests"
    BUILD_SCRIPT = "build script"
    EXCLUDED = "excluded by pattern"


@final
@dataclass(frozen=True, slots=True)
class Skipped:
    """A folder or Python file that was left out, and why."""

    relative: str
    reason: SkipReason


@final
@dataclass(frozen=True, slots=True, eq=False)
class Workspace:
    """All that a run reads, in the order of the relative paths; `root` is the folder that all of it has in common."""

    root: Path
    files: tuple[SourceFile, ...] = ()
    launch_files: tuple[SourceFile, ...] = ()
    packages: tuple[Package, ...] = ()
    executables: tuple[Executable, ...] = ()
    interface_files: tuple[SourceFile, ...] = ()
    cpp_sources: tuple[SourceFile, ...] = ()
    """What is compiled as C++; headers are found by what includes them."""
    skipped: tuple[Skipped, ...] = ()
    findings: tuple[Finding, ...] = ()
    targets: tuple[Target, ...] = ()
    excluded: Exclusions = _NOTHING
    """What is not read, wherever an import or a launch file may lead."""
    boundary: Boundary = EVERYWHERE
    """Where links may lead."""
    environment: Mapping[str, str] = field(default_factory=lambda: ROS_2)
    """The environment variables that build descriptions were read with."""
