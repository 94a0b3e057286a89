# SPDX-License-Identifier: Apache-2.0
"""What does one analysis leave in its folder?

report.html, policy.xml, policies/…, permissions/…, network.json, graph.*, findings.*   the outputs of `rosward extract`
findings.txt       what the terminal would print
flow.json          what each output is made of, where that is asked for
changes.txt        nodes, entities and rights that came and went, where there is an earlier result of the same sources
outputs.zip        all of these
summary.json       what the page shows of them (written last)
"""

from __future__ import annotations

import contextlib
import io
import json
import shutil
import tempfile
import zipfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

from rosward.deployment.request import LaunchRequest, Request
from rosward.diff.compare import compare, read_snapshot
from rosward.enclaves.grants import enclaves
from rosward.influence.executed import executed
from rosward.influence.graph import graph_of
from rosward.network.connect import with_findings
from rosward.network.counts import counts_of
from rosward.network.graph import Network
from rosward.network.loose_ends import LOOSE_ENDS, loose_ends
from rosward.outputs.background import Background
from rosward.outputs.documents.flow_json import flow_json
from rosward.outputs.files import write_outputs
from rosward.outputs.formats import BY_NAME
from rosward.outputs.terminal.diff_text import diff_text
from rosward.outputs.terminal.paper import Plain
from rosward.outputs.terminal.summary import summary
from rosward.outputs.whole_files import write_text
from rosward.outputs.writing import Material, Scan, of_enclave
from rosward.pipeline import Budget, extract
from rosward.rules import Severity
from rosward.server.job import Job
from rosward.server.launch_files import launch_files
from rosward.server.places import LeftOut, read_left_out, write_left_out
from rosward.server.settings import Settings
from rosward.server.telling import Teller
from rosward.server.unpacking import unpack
from rosward.source.json_fields import UnreadableError
from rosward.suppression.judge import SourceTexts, Wishes, of_no_file, review

__all__ = ["analyse"]

_MOST_LEFT_OUT: Final = 200
_MOST_ENCLAVES: Final = 1_000


def analyse(job: Job, tell: Teller) -> None:
    """Do a job. Raises UploadRefusedError, and what `extract` raises."""
    left_out = _unpacked(job, tell)
    settings, root, output = job.settings, Path(job.root), Path(job.output)
    request = _request(settings)
    result = extract(
        root,
        distro=settings.distro,
        unknown=settings.unknown,
        tests=settings.tests,
        request=request,
        env=dict(settings.env),
        enclaves=settings.enclaves,
        budget=Budget(flow=settings.flows),
        progress=tell,
    )
    tell("writing", 0, 1)
    flowing = tuple(executed(result.network.nodes)) if settings.flows else ()
    network = with_findings(result.network, flowing)
    findings = (*network.findings, *loose_ends(network))
    found = review(findings, SourceTexts(result.root, result.files), Wishes(), unused=not request.deploys)
    loose = tuple(f for f in found.findings if f.code in LOOSE_ENDS)
    reviewed = found._replace(shown=tuple(j for j in found.shown if j.finding.code not in LOOSE_ENDS))
    network = replace(network, findings=reviewed.findings)
    written = write_outputs(
        Material(
            network, settings.unknown, background=Background(result.root, result.systems, loose, flow=settings.flows)
        ),
        job.output,
        BY_NAME,
        Scan(reviewed.shown),
    )
    reviewed = reviewed._replace(shown=(*reviewed.shown, *of_no_file(written.findings)))
    network = with_findings(network, written.findings)
    printed = io.StringIO()
    summary(network, Plain(printed), verbose=True, reviewed=reviewed)
    write_text(job.output, "findings.txt", printed.getvalue())
    if settings.flows:
        write_text(job.output, "flow.json", flow_json(network.nodes, graph_of(network.nodes), flowing))
    changed = _changes(job)
    files = _files_below(output)
    _pack(output, files)
    document = {
        **_numbers(network),
        "complete": reviewed.complete,
        "enclaves": _enclaves(network, settings),
        "files": files,
        "changed": changed,
        "launch_files": [
            {**file._asdict(), "arguments": [argument._asdict() for argument in file.arguments]}
            for file in launch_files(root, settings.distro, dict(settings.env))
        ],
        "left_out": [entry._asdict() for entry in left_out[:_MOST_LEFT_OUT]],
        "left_out_count": len(left_out),
    }
    write_text(job.output, "summary.json", json.dumps(document))


def _unpacked(job: Job, tell: Teller) -> list[LeftOut]:
    """What was left out of an upload. An archive is unpacked, once: its folder is renamed to `root` when it is whole."""
    if job.notes is None:
        return []
    root, notes = Path(job.root), Path(job.notes)
    if job.archive is None or root.is_dir():
        return read_left_out(notes)
    partly = Path(tempfile.mkdtemp(prefix="unpacking-", dir=job.output))  # it goes with the result if this is killed
    try:
        left_out = unpack(Path(job.archive), partly, job.limits, lambda done, count: tell("unpacking", done, count))
        write_left_out(notes, left_out)
        with contextlib.suppress(OSError):  # another analysis of the same upload was faster, and has made the same
            partly.rename(root)
    finally:
        shutil.rmtree(partly, ignore_errors=True)
    return left_out


def _request(settings: Settings) -> Request:
    launches = tuple(LaunchRequest(file) for file in settings.launch)
    return Request(launches, arguments=settings.arguments, all_launch=settings.all_launch)


def _numbers(network: Network) -> dict[str, object]:
    counts = counts_of(network)
    return {
        "distro": network.distro,
        "read": {"files": network.files, "lines": network.lines},
        "nodes": counts.nodes,
        "processes": network.processes,
        "topics": counts.topics.total - counts.topics.system,
        "services": counts.services.total - counts.services.system,
        "actions": counts.actions.total - counts.actions.system,
        "findings": {severity.value: counts.severities[severity] for severity in Severity},
        "names": {resolution.value: number for resolution, number in counts.names.items() if number},
    }


def _enclaves(network: Network, settings: Settings) -> list[dict[str, object]]:
    """Each enclave: its nodes, how many rules it has for their own entities, how many are left out, and the file."""
    found: list[dict[str, object]] = []
    for enclave in enclaves(network, settings.unknown)[:_MOST_ENCLAVES]:
        own = [g for p in enclave.profiles for g in p.grants if not all(e.system for e in g.entities)]
        found.append(
            {
                "path": enclave.path,
                "nodes": [node.fqn for profile in enclave.profiles for node in profile.nodes],
                "rules": len(own),
                "left_out": sum(len(profile.omissions) for profile in enclave.profiles),
                "file": of_enclave("policies", enclave.path, "policy.xml"),
            }
        )
    return found


def _changes(job: Job) -> int:
    """Compare with the earlier result of the same sources; the number of lines that came or went."""
    if job.earlier is None:
        return 0
    try:
        text = diff_text(compare(read_snapshot(job.earlier), read_snapshot(str(Path(job.output) / "network.json"))))
    except UnreadableError:
        return 0
    write_text(job.output, "changes.txt", text)
    return sum(line.startswith(("  + ", "  - ")) for line in text.splitlines())


def _files_below(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def _pack(folder: Path, files: Sequence[str]) -> None:
    """All outputs as one zip, the same bytes for the same outputs."""
    with zipfile.ZipFile(folder / "outputs.zip", "w", zipfile.ZIP_DEFLATED) as packed:
        for name in files:
            entry = zipfile.ZipInfo(f"rosward-out/{name}", (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            packed.writestr(entry, (folder / name).read_bytes())
