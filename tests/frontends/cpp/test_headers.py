# SPDX-License-Identifier: Apache-2.0
"""Promise: an `#include` leads to files of the sources and nowhere else."""

from __future__ import annotations

from pathlib import Path

import pytest
from source.trees import write

from rosward.findings import Finding
from rosward.frontends.cpp.headers import Headers
from rosward.frontends.cpp.preprocess import Preprocessor
from rosward.source.boundary import Boundary

FILES = {
    "ws/src/main.cpp": "",
    "ws/src/here.hpp": "",
    "ws/src/both.hpp": "",
    "ws/include/demo/a.hpp": "",
    "ws/include/both.hpp": "",
    "ws/include/folder.hpp/": "",
    "elsewhere/secret.hpp": "int secret;",
}


@pytest.fixture
def headers(tmp_path: Path) -> Headers:
    write(tmp_path, FILES)
    root = tmp_path / "ws"
    (root / "include" / "link.hpp").symlink_to(tmp_path / "elsewhere" / "secret.hpp")
    return Headers(root, [str(root)], Boundary([str(root)]))


@pytest.mark.parametrize(
    ("name", "quoted", "expected"),
    [
        ("here.hpp", True, "src/here.hpp"),
        ("here.hpp", False, None),
        ("both.hpp", True, "src/both.hpp"),
        ("both.hpp", False, "include/both.hpp"),
        ("demo/a.hpp", False, "include/demo/a.hpp"),
        ("./demo/../both.hpp", False, "include/both.hpp"),
        ("../include/demo/a.hpp", True, "include/demo/a.hpp"),
        ("folder.hpp", False, None),
        ("gone.hpp", True, None),
        ("link.hpp", False, None),
        ("../../elsewhere/secret.hpp", True, None),
        ("/etc/passwd", True, None),
        ("here.hpp\0", True, None),
        ("./" * 300 + "here.hpp", True, None),
    ],
)
def test_where_an_include_leads(
    headers: Headers, tmp_path: Path, name: str, quoted: bool, expected: str | None
) -> None:
    root = tmp_path / "ws"
    found = headers.find(
        name, str(root / "src" / "main.cpp"), [str(root / "include"), str(tmp_path / "elsewhere")], quoted
    )
    assert (found and Path(found).relative_to(root).as_posix()) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("core/part.hpp", "src/core/part.hpp"),
        ("lamp/folder.hpp", "include/lamp/folder.hpp"),
        ("src/core/part.hpp", "src/core/part.hpp"),
        ("main.cpp", None),
        ("core/../../../elsewhere/secret.hpp", None),
        ("/etc/passwd", None),
        ("core/part.hpp\0", None),
        ("a/" * 300 + "part.hpp", None),
        ("rclcpp/rclcpp.hpp", None),
        ("tf2_ros/buffer.h", None),
        ("std_msgs/msg/string.hpp", None),
    ],
)
def test_a_header_above(headers: Headers, tmp_path: Path, name: str, expected: str | None) -> None:
    root = tmp_path / "ws"
    elsewhere = ("src/rclcpp/rclcpp.hpp", "include/tf2_ros/buffer.h", "std_msgs/msg/string.hpp")
    for path in ("src/core/part.hpp", "include/lamp/folder.hpp", *elsewhere):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).touch()
    found = headers.above(name, str(root / "src" / "deep" / "main.cpp"))
    assert found == (expected and f"{root}/{expected}")
    assert headers.find(name, str(root / "src" / "deep" / "main.cpp"), [], quoted=False) is None


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"int a;\r\nint b;\rint c;\n", "int a;\nint b;\nint c;\n"),
        (b"\xef\xbb\xbfint a;", "int a;"),
        (b"// \xff\0", "// \ufffd "),
    ],
)
def test_the_text_of_a_file(headers: Headers, tmp_path: Path, data: bytes, text: str) -> None:
    path = tmp_path / "ws" / "src" / "main.cpp"
    path.write_bytes(data)
    assert headers.read(str(path)) == text


def test_a_file_that_cannot_be_read_is_told(headers: Headers, tmp_path: Path) -> None:
    finding = headers.read(str(tmp_path / "ws" / "src" / "gone.cpp"))
    assert isinstance(finding, Finding)
    assert (finding.code, finding.place.file) == ("RW002", "src/gone.cpp")


def test_a_unit_of_files_on_disk(headers: Headers, tmp_path: Path) -> None:
    root = tmp_path / "ws"
    write(
        root,
        {
            "src/main.cpp": '#include <demo/a.hpp>\nint x = A;\n#include "link.hpp"\n',
            "include/demo/a.hpp": "#define A 5\n",
        },
    )
    unit = Preprocessor(headers.read, headers.named, headers.find).translate(
        str(root / "src" / "main.cpp"), [str(root / "include")], []
    )
    assert [file.file for file in unit.files] == ["include/demo/a.hpp", "src/main.cpp"]
    assert unit.files[-1].text.split("\n")[1] == "int x = 5;"
    assert unit.files[-1].external == ("link.hpp",)
