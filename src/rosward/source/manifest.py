# SPDX-License-Identifier: Apache-2.0
"""What does a `package.xml` say?

    <package format="3"><name>demo</name>…<export><build_type>ament_python</build_type></export></package>
    ->  Manifest(name="demo", build_type="ament_python", depends={"rclpy", …})

`catkin_pkg` reads it, as the ROS tools do. A first pass of our own sees to it that only harmless documents get that
far (no document type, so no entities; bounded depth and conditions) and keeps the name of a package that `catkin_pkg`
rejects: its nodes are real.
"""

from __future__ import annotations

from collections.abc import Mapping
from xml.parsers import expat

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits
from rosward.source.surroundings import ROS_2
from rosward.source.text import read_bytes
from rosward.source.xml_events import RefusedXmlError, parse


class Manifest(NamedTuple):
    """What a package says of itself."""

    name: str
    build_type: str
    depends: frozenset[str] = frozenset()


def read_manifest(
    path: str, file: str, folder_name: str, environment: Mapping[str, str] = ROS_2
) -> tuple[Manifest, Finding | None]:
    """The manifest at `path`, called `file`, and what is wrong with it.

    `folder_name` stands in for a name that cannot be read; conditions are evaluated under `environment`.
    """
    data = read_bytes(path, file, limits.MANIFEST_FILE)
    if isinstance(data, Finding):
        return Manifest(folder_name, ""), Finding("RW017", data.message, data.place)
    outline = _Outline()
    problem = outline.read(data)
    manifest = Manifest(outline.name or folder_name, outline.build_type)
    if problem is not None:
        message, line = problem
        return manifest, Finding("RW017", message, Place(file, line))
    try:
        return _through_catkin_pkg(data, environment), None
    except Exception as error:  # catkin_pkg raises AssertionError, ValueError, InvalidPackage and others
        reason = " ".join(str(error).replace(path, file).split())[:300] or type(error).__name__
        message = f"The ROS tools reject this package.xml and would not build the package: {reason}"
        return manifest, Finding("RW017", message, Place(file))


def _through_catkin_pkg(data: bytes, environment: Mapping[str, str]) -> Manifest:
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from catkin_pkg.package import parse_package_string

        package = parse_package_string(data, warnings=[])
        package.evaluate_conditions(dict(environment))
        build_type = str(package.get_build_type())
    needs = [*package.build_depends, *package.build_export_depends, *package.exec_depends]
    depends = frozenset(str(each.name) for each in needs if each.evaluated_condition is not False)
    return Manifest(str(package.name), build_type, depends)


class _Outline:
    """The name and the build type of a manifest, as far as it can be read."""

    def __init__(self) -> None:
        self.name = ""
        self.build_type = ""
        self._path: list[str] = []
        self._text: list[str] = []
        self._count = 0

    def read(self, data: bytes) -> tuple[str, int] | None:
        """What is wrong with the document, and in which line."""
        parser = expat.ParserCreate()
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._text.append
        return parse(parser, data, "The package.xml")

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        self._path.append(tag)
        self._text.clear()
        if len(self._path) > limits.MANIFEST_DEPTH:
            raise RefusedXmlError("The package.xml is nested too deeply.")
        self._count += 1
        if self._count > limits.MANIFEST_ELEMENTS:
            raise RefusedXmlError("The package.xml has too many elements.")
        condition = attributes.get("condition", "")
        if len(condition) > limits.MANIFEST_CONDITION or condition.count("(") > 3:
            raise RefusedXmlError("The package.xml has a condition that is too complex to evaluate.")

    def _end(self, _: str) -> None:
        if self._path == ["package", "name"] and not self.name:
            self.name = "".join(self._text).strip()
        elif self._path == ["package", "export", "build_type"] and not self.build_type.startswith("ament"):
            self.build_type = "".join(self._text).strip()
        self._text.clear()
        self._path.pop()
