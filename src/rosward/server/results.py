# SPDX-License-Identifier: Apache-2.0
"""Which results are there, in which state is each, and where do their files lie?

    FOLDER/results/6f0c…/result.json    what it is of, with which settings, how it ended
    FOLDER/results/6f0c…/out/…          the outputs
    FOLDER/sources/91ab…/tree/…         what was uploaded, for all results of it

A bounded number is kept: the oldest goes when a new one comes, and an upload with the last result of it. In a folder that the user named,
results of an earlier server are read again; what is not of this form there is left alone.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import re
import secrets
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Final, final

from rosward.findings import Finding
from rosward.outputs.whole_files import write_text
from rosward.server.job import JobStep
from rosward.server.limits import Limits
from rosward.server.places import UploadRefusedError
from rosward.server.settings import Settings, read_settings
from rosward.source import limits
from rosward.source.text import read_bytes

__all__ = ["ENDED", "AnalysedSource", "Results", "StoredResult"]

ENDED: Final = frozenset({"done", "failed", "cancelled"})
_STATES: Final = frozenset({"waiting", "running"}) | ENDED
_KINDS: Final = frozenset({"upload", "example", "workspace"})
_ID: Final = re.compile(r"[0-9a-f]{16}")


@final
@dataclass(frozen=True)
class AnalysedSource:
    """What is analysed: `key` is the path of a workspace, else the id of the folder into which it was uploaded. `zipped`: it came as a zip."""

    kind: str
    key: str
    title: str
    zipped: bool = False


@final
@dataclass(frozen=True)
class StoredResult:
    """One analysis. `state` is waiting, running, done, failed or cancelled; `automatic`: a change of the workspace asked for it."""

    id: str
    source: AnalysedSource
    settings: Settings
    created: float
    state: str = "waiting"
    message: str = ""
    automatic: bool = False
    step: JobStep | None = None
    summary: dict[str, object] = field(default_factory=dict)

    @property
    def group(self) -> str:
        """The same for all results of the same sources with the same settings."""
        text = json.dumps([self.source.kind, self.source.key, self.settings.document()])
        return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]


@final
class Results:
    """The results in a folder, newest first. `changed` is called after each change."""

    def __init__(self, folder: Path, limits: Limits, changed: Callable[[], None]) -> None:
        self._folder = folder
        self._limits = limits
        self._changed = changed
        self._results: dict[str, StoredResult] = {}
        for name in ("results", "sources"):
            (folder / name).mkdir(mode=0o700, parents=True, exist_ok=True)
        for result in sorted(self._read(), key=lambda r: r.created):
            self._results[result.id] = result

    def all(self) -> list[StoredResult]:
        """All, newest first."""
        return list(reversed(self._results.values()))

    def get(self, identifier: str) -> StoredResult | None:
        """The result of an id."""
        return self._results.get(identifier)

    def output(self, result: StoredResult) -> Path:
        """The folder of its outputs."""
        return self._folder / "results" / result.id / "out"

    def root(self, source: AnalysedSource) -> Path:
        """The folder (or file) that is analysed."""
        return Path(source.key) if source.kind == "workspace" else self.upload(source) / "tree"

    def upload(self, source: AnalysedSource) -> Path:
        """The folder of what was uploaded, with notes on it."""
        return self._folder / "sources" / source.key

    def new_upload(self) -> tuple[str, Path]:
        """A key, and a folder for what is uploaded. A mark keeps the analysis from looking for packages above it."""
        key = secrets.token_hex(8)
        folder = self._folder / "sources" / key
        folder.mkdir(mode=0o700)
        (folder / ".git").touch()
        return key, folder

    def drop_upload(self, key: str) -> None:
        """Remove what was uploaded."""
        shutil.rmtree(self._folder / "sources" / key, ignore_errors=True)

    def add(self, source: AnalysedSource, settings: Settings, *, automatic: bool = False) -> StoredResult:
        """A new result, which waits."""
        result = StoredResult(secrets.token_hex(8), source, settings, time.time(), automatic=automatic)
        self.output(result).mkdir(mode=0o700, parents=True)
        self._results[result.id] = result
        self._keep(result)
        ended = [r for r in self._results.values() if r.state in ENDED]
        for old in ended[: max(0, len(self._results) - self._limits.results)]:
            self.delete(old.id)
        self._changed()
        return result

    def step(self, identifier: str, step: JobStep) -> None:
        """Progress of a result."""
        known = self._results.get(identifier)
        if known is not None:
            self._results[identifier] = replace(known, state="running", step=step)
            self._changed()

    def end(self, identifier: str, state: str, message: str = "") -> None:
        """A result has ended. Of a done one the summary is read."""
        known = self._results.get(identifier)
        if known is None:
            return
        summary: dict[str, object] = {}
        if state == "done":
            try:
                summary = _read_json(self.output(known) / "summary.json")
            except UploadRefusedError:
                state, message = "failed", "The result cannot be read."
        if state != "done":
            shutil.rmtree(self.output(known), ignore_errors=True)
        self._results[identifier] = replace(known, state=state, message=message, step=None, summary=summary)
        with contextlib.suppress(OSError):  # a later server then says that this one ended before it did
            self._keep(self._results[identifier])
        self._changed()

    def delete(self, identifier: str) -> None:
        """Remove a result, and what was uploaded for it unless another one is of that."""
        gone = self._results.pop(identifier, None)
        if gone is None:
            return
        shutil.rmtree(self.output(gone).parent, ignore_errors=True)
        if gone.source.kind != "workspace" and all(r.source.key != gone.source.key for r in self._results.values()):
            self.drop_upload(gone.source.key)
        self._changed()

    def touch(self) -> None:
        """Something that is shown with the results has changed."""
        self._changed()

    def _keep(self, result: StoredResult) -> None:
        document = {
            "id": result.id,
            "source": vars(result.source),
            "settings": result.settings.document(),
            "created": result.created,
            "state": result.state,
            "message": result.message,
            "automatic": result.automatic,
        }
        write_text(str(self.output(result).parent), "result.json", json.dumps(document))

    def _read(self) -> list[StoredResult]:
        """The results that an earlier server left here."""
        found: list[StoredResult] = []
        for entry in os.scandir(self._folder / "results"):
            if _ID.fullmatch(entry.name) and entry.is_dir(follow_symlinks=False):
                try:
                    found.append(self._read_one(entry.name))
                except (UploadRefusedError, KeyError, TypeError, ValueError):
                    continue
        return found

    def _read_one(self, identifier: str) -> StoredResult:
        folder = self._folder / "results" / identifier
        document = _read_json(folder / "result.json")
        source = AnalysedSource(**_fields(document["source"], kind=str, key=str, title=str, zipped=bool))
        whole = _fields(document, created=float, state=str, message=str, automatic=bool)
        if source.kind not in _KINDS or whole["state"] not in _STATES or not math.isfinite(whole["created"]):
            raise UploadRefusedError("unexpected form")
        if source.kind != "workspace" and not _ID.fullmatch(source.key):
            raise UploadRefusedError("unexpected form")
        if whole["state"] not in ENDED:
            whole |= {"state": "failed", "message": "The server stopped before the analysis finished."}
        summary = _read_json(folder / "out" / "summary.json") if whole["state"] == "done" else {}
        return StoredResult(identifier, source, read_settings(document["settings"]), **whole, summary=summary)


def _fields(document: object, **kinds: type) -> dict[str, Any]:
    """The fields of a JSON object, each of its kind. Raises UploadRefusedError."""
    if not isinstance(document, dict) or any(not isinstance(document.get(name), kind) for name, kind in kinds.items()):
        raise UploadRefusedError("unexpected form")
    return {name: document[name] for name in kinds}


def _read_json(file: Path) -> dict[str, object]:
    data = read_bytes(file, file.name, limits.RESULT_FILE)
    if isinstance(data, Finding) or file.is_symlink():
        raise UploadRefusedError("not a result file")
    try:
        document = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise UploadRefusedError(str(error)) from error
    if not isinstance(document, dict):
        raise UploadRefusedError("unexpected form")
    return document
