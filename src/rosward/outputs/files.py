# SPDX-License-Identifier: Apache-2.0
"""Which files does the output folder get? The formats stand in `formats.py`; how a file is written, in `whole_files.py`."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from rosward.findings import Finding
from rosward.guard import internal_error
from rosward.location import Place
from rosward.network.connect import with_findings
from rosward.outputs.formats import FORMATS, Format
from rosward.outputs.pictures import Pictures
from rosward.outputs.whole_files import write_text
from rosward.outputs.writing import File, Material, Scan, files, text
from rosward.records import NamedTuple
from rosward.source import disk
from rosward.suppression.judge import of_no_file

__all__ = ["Written", "write_outputs"]


class Written(NamedTuple):
    """The paths that were written, without those of single enclaves, and what is told of formats that were not."""

    paths: list[str]
    findings: tuple[Finding, ...] = ()


def write_outputs(
    material: Material, folder: str, formats: Collection[str], scan: Scan | None = None, *, net: bool = True
) -> Written:
    """Write the chosen formats below `folder`.

    Formats of findings need a `scan`. Raises OSError where that is not possible. A format that cannot be made for a fault of rosward is a
    finding (RW299), which the others show; without `net` that is raised.
    """
    material = material._replace(pictures=material.pictures or Pictures())
    chosen = [each for each in FORMATS if each.name in formats and each.files]
    written: dict[str, dict[str, None]] = {}
    failed: dict[str, Finding] = {}

    def write(one: Format) -> None:
        paths = written.setdefault(one.name, {})
        for name, content in _files(one, material, scan, failed.values()):
            path = write_text(folder, name, content)
            disk.wrote(folder, name, content.encode())
            if "/" not in name:
                paths[path] = None

    def attempt(one: Format) -> None:
        try:
            write(one)
        except OSError:
            raise
        except Exception as error:
            if not net:
                raise
            failed[one.name] = internal_error(error, Place("", 0), f"the format {one.name} was not written")

    for one in chosen:
        attempt(one)
    if failed:  # those before it do not tell of it yet
        for one in chosen:
            if one.tells and one.name not in failed:
                attempt(one)
    return Written([path for paths in written.values() for path in paths], tuple(failed.values()))


def _files(chosen: Format, material: Material, scan: Scan | None, failures: Collection[Finding]) -> Iterable[File]:
    """The files of a format, which tell of what went wrong with others."""
    if chosen.needs != "findings":
        return files(chosen, material._replace(network=with_findings(material.network, failures)))
    if scan is None:
        return ()
    told = scan._replace(findings=(*scan.findings, *of_no_file(failures)))
    return [(name, text(chosen, told)) for name in chosen.files]
