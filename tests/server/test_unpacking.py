# SPDX-License-Identifier: Apache-2.0
"""Zips that nobody means well with: each is refused, or what is wrong in it is left out; nothing is ever written outside of the folder."""

from __future__ import annotations

import io
import stat
import struct
import zipfile
from pathlib import Path

import pytest

from rosward.server.limits import Limits
from rosward.server.places import LeftOut, UploadRefusedError
from rosward.server.unpacking import unpack

from .page import packed

SMALL = Limits(upload=2**20, file=50_000, files=20, unpacked=100_000, depth=5)


def unpacked(data: bytes, tmp_path: Path, limits: Limits = SMALL) -> tuple[list[str], list[LeftOut]]:
    """The files that are there behind it, and what was left out; nothing may have come to be beside the folder."""
    archive, folder = tmp_path / "upload.zip", tmp_path / "tree"
    archive.write_bytes(data)
    folder.mkdir()
    left_out = unpack(archive, folder, limits, lambda _done, _all: None)
    return sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()), left_out


def refused(data: bytes, tmp_path: Path, why: str | None, limits: Limits = SMALL) -> None:
    with pytest.raises(UploadRefusedError, match=why):
        unpacked(data, tmp_path, limits)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["tree", "upload.zip"]


def with_entry(info: zipfile.ZipInfo, content: bytes) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr(info, content)
    return data.getvalue()


def test_files_come_out_as_they_went_in(tmp_path: Path) -> None:
    files, left_out = unpacked(packed({"ws/src/a.py": b"a = 1\n", "ws/b.yaml": b"b: 1"}), tmp_path)
    assert files == ["ws/b.yaml", "ws/src/a.py"]
    assert left_out == []
    assert (tmp_path / "tree/ws/src/a.py").read_bytes() == b"a = 1\n"
    assert stat.S_IMODE((tmp_path / "tree/ws/src/a.py").stat().st_mode) == 0o600


@pytest.mark.parametrize(
    "name", ["../evil.py", "a/../../evil.py", "/tmp/evil.py", "C:/evil.py", "..\\evil.py", "a\\b.py", "evil\n.py"]
)
def test_a_name_that_leads_outside(name: str, tmp_path: Path) -> None:
    refused(packed({"good.py": b"", name: b"evil"}), tmp_path, None)
    assert not any((tmp_path / "tree").iterdir()), "nothing is written before all names are judged"


def test_a_folder_that_leads_outside(tmp_path: Path) -> None:
    refused(packed({"../evil/": b""}), tmp_path, "leaves the folder")


def test_a_nul_in_a_name_does_not_shorten_it(tmp_path: Path) -> None:
    data = packed({"evil.py#.txt": b"x"}).replace(b"evil.py#.txt", b"evil.py\0.txt")
    refused(data, tmp_path, "unprintable characters")


def test_a_link_is_not_made(tmp_path: Path) -> None:
    info = zipfile.ZipInfo("passwd.py")
    info.create_system = 3
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    files, left_out = unpacked(with_entry(info, b"/etc/passwd"), tmp_path)
    assert (files, left_out) == ([], [LeftOut("passwd.py", "a link")])


def test_a_link_to_a_folder_and_a_file_in_it(tmp_path: Path) -> None:
    link = zipfile.ZipInfo("out")
    link.create_system = 3
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr(link, str(tmp_path))
        archive.writestr("out/evil.py", "evil")
    refused(data.getvalue(), tmp_path, "listed twice")


@pytest.mark.parametrize("kind", [stat.S_IFCHR, stat.S_IFIFO, stat.S_IFSOCK, stat.S_IFBLK])
def test_a_device_is_not_made(kind: int, tmp_path: Path) -> None:
    info = zipfile.ZipInfo("device.py")
    info.create_system = 3
    info.external_attr = (kind | 0o666) << 16
    assert unpacked(with_entry(info, b""), tmp_path) == ([], [LeftOut("device.py", "not a regular file")])


def test_two_names_for_one_place(tmp_path: Path) -> None:
    refused(packed({"demo/a.py": b"1", "Demo/a.py": b"2"}), tmp_path, "identical names on some systems")


def test_one_file_of_nothing_but_zeros(tmp_path: Path) -> None:
    limits = SMALL._replace(file=50_000_000, unpacked=50_000_000)
    refused(packed({"bomb.py": bytes(5_000_000)}), tmp_path, "times its size", limits)


def test_a_file_larger_than_a_program_is_left_out(tmp_path: Path) -> None:
    files, left_out = unpacked(packed({"a.py": b"", "data.yaml": bytes(60_000)}), tmp_path)
    assert (files, left_out) == (["a.py"], [LeftOut("data.yaml", "larger than 50,000 bytes")])


def test_many_files_that_are_too_much_together(tmp_path: Path) -> None:
    refused(
        packed({f"{n}.py": bytes(40_000) for n in range(4)}), tmp_path, "more than 100,000 bytes once it is unpacked"
    )


def test_an_archive_that_lies_about_sizes(tmp_path: Path) -> None:
    honest = packed({"bomb.py": bytes(90_000)})
    lying = honest.replace(struct.pack("<L", 90_000), struct.pack("<L", 10))
    refused(lying, tmp_path, None)
    assert sum(p.stat().st_size for p in (tmp_path / "tree").rglob("*")) <= 50_000


def test_more_files_than_are_allowed(tmp_path: Path) -> None:
    refused(packed({f"{n}.py": b"" for n in range(21)}), tmp_path, "more than 20 files")


def test_a_list_of_entries_that_is_too_long_is_not_read(tmp_path: Path) -> None:
    refused(packed({f"{n}.py": b"" for n in range(2_000)}), tmp_path, "more than 20 files")


def test_entries_that_overlap(tmp_path: Path) -> None:
    """Many entries of one stored file: small on disk, large when unpacked."""
    data = packed({"a.py": b"x" * 30_000}, zipfile.ZIP_STORED)
    start = data.index(b"PK\x01\x02")
    entry = data[start : data.index(b"PK\x05\x06")]
    entries = b"".join(entry.replace(b"a.py", b"%c.py" % (97 + n)) for n in range(3))
    end = struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, 3, 3, len(entries), start, 0)
    refused(data[:start] + entries + end, tmp_path, "overlap")


def test_folders_within_each_other(tmp_path: Path) -> None:
    refused(packed({"a/b/c/d/e/f.py": b""}), tmp_path, "folders within each other")


def test_what_is_no_source_is_left_out_and_does_not_count(tmp_path: Path) -> None:
    files = {
        "a.py": b"",
        "./": b"",
        ".git/": b"",
        **{f".git/objects/{n}": b"x" for n in range(25)},
        "arm.stl": b"solid",
    }
    kept, left_out = unpacked(packed(files), tmp_path)
    assert (kept, len(left_out)) == (["a.py"], 26)
    assert LeftOut("arm.stl", "not text") in left_out


def test_a_zip_within_a_zip_stays_closed(tmp_path: Path) -> None:
    inner = packed({"bomb.py": bytes(1_000)})
    assert unpacked(packed({"a.py": b"", "inner.zip": inner}), tmp_path)[0] == ["a.py"]


def test_a_method_that_is_not_read(tmp_path: Path) -> None:
    refused(packed({"a.py": b"x"}, zipfile.ZIP_LZMA), tmp_path, "unsupported compression method")


def test_an_encrypted_entry(tmp_path: Path) -> None:
    data = bytearray(packed({"a.py": b"x"}))
    data[6] |= 1
    data[data.index(b"PK\x01\x02") + 8] |= 1
    refused(bytes(data), tmp_path, "encrypted")


def test_the_form_for_very_large_archives(tmp_path: Path) -> None:
    data = packed({"a.py": b"x"})
    end = data.index(b"PK\x05\x06")
    locator = struct.pack("<4sLQL", b"PK\x06\x07", 0, 0, 1)
    refused(data[:end] + locator + data[end:], tmp_path, "zip64")


@pytest.mark.parametrize("data", [b"", b"PK", b"PK\x05\x06", b"no zip" * 100, packed({"a.py": b"x"})[:-10]])
def test_what_is_no_zip(data: bytes, tmp_path: Path) -> None:
    refused(data, tmp_path, "not a readable zip file")


def test_every_byte_changed_ends_in_files_or_a_refusal(tmp_path: Path) -> None:
    data = packed({"demo/a.py": b"print(1)\n" * 20, "b.yaml": b"a: 1"})
    for place in range(len(data)):
        folder = tmp_path / str(place)
        folder.mkdir()
        broken = bytearray(data)
        broken[place] ^= 0xFF
        try:
            unpacked(bytes(broken), folder)
        except UploadRefusedError:
            continue
        finally:
            assert {p.name for p in folder.iterdir()} == {"tree", "upload.zip"}
