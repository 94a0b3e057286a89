# SPDX-License-Identifier: Apache-2.0
"""Do two checkouts of rosward say the same, byte for byte?

python bench/same.py OLD NEW FOLDER…                          each FOLDER alone, in every format; exits 1 where something differs
python bench/same.py OLD NEW --each DIR --each DIR            each folder in DIR
python bench/same.py OLD NEW FOLDER --every                   every command that analyses, not only extract (with and without --all-launch)
python bench/same.py OLD NEW FOLDER --keep DIR                what OLD said is kept in DIR, and read there the next time
python bench/same.py OLD NEW FOLDER --allow 's/was/is/'       texts of OLD are changed so before they are compared; may be repeated
python bench/same.py OLD NEW FOLDER --ignore '"models": .*'   what it means counts in neither; may be repeated

OLD and NEW are checkouts (with `src/`). Both run with this Python, one process for each command, so neither sees the modules of the other.
Compared: each file that is written, standard output, standard error and exit code of each command. The path of the output folder is the only
thing that is taken out; of a report its document is compared, not the scripts of its page. The first lines that
differ are shown.
"""

from __future__ import annotations

import argparse
import difflib
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Final

from rosward.outputs.report.packed import document_in

_FORMATS: Final = "json,policy,permissions,dot,mermaid,svg,html,sarif,junit"
_POLICY: Final = '<policy version="0.2.0"><enclaves><enclave path="/"><profiles/></enclave></enclaves></policy>\n'
_LINES: Final = 12
"""So many lines of a difference are shown."""


def _commands(folder: str, *, every: bool) -> Iterator[tuple[str, list[str]]]:
    """What is asked of a folder: a label and a command, in whose words `OUT` is the output folder, `POLICY` a policy that grants nothing."""
    yield "extract", ["extract", folder, "--format", _FORMATS, "-o", "OUT", "--system", "-v"]
    yield "launched", ["extract", folder, "--all-launch", "--format", _FORMATS, "-o", "OUT"]
    if every:
        yield "tree", ["launch-tree", folder, "--all-launch", "--json"]
        yield (
            "plain",
            [
                "extract",
                folder,
                "--format",
                "json,policy",
                "-o",
                "OUT",
                "--unknown",
                "wildcard",
                "--no-assumed",
                "--distro",
                "humble",
            ],
        )
        for kind in ("nodes", "topics", "services", "actions", "packages", "parameters"):
            yield f"list {kind}", ["list", kind, folder]
        for form in ("text", "json", "sarif", "junit", "github"):
            yield f"check {form}", ["check", "POLICY", folder, "--format", form]
        yield "explain", ["explain", "/rosout", folder]
        yield "explain json", ["explain", "/rosout", folder, "--json"]
        yield "enclaves", ["enclaves", "suggest", folder]


class Said(dict[str, bytes]):
    """What a command said: each file that it wrote, and `stdout`, `stderr`, `exit code`."""


def said(checkout: Path, command: Sequence[str]) -> Said:
    """Run one command of a checkout."""
    with tempfile.TemporaryDirectory() as place:
        out, policy = Path(place) / "out", Path(place) / "policy.xml"
        policy.write_text(_POLICY, encoding="utf-8")
        words = [{"OUT": str(out), "POLICY": str(policy)}.get(word, word) for word in command]
        environment = {
            **os.environ,
            "PYTHONPATH": str(checkout / "src"),
            "COLUMNS": "160",
            "NO_COLOR": "1",
            "PYTHONHASHSEED": "0",
            "ROSWARD_NO_CACHE": "1",
        }
        done = subprocess.run(
            [sys.executable, "-m", "rosward", *words], capture_output=True, env=environment, cwd=place, check=False
        )
        found = Said()
        for path in sorted(out.rglob("*")):
            if path.is_file():
                text = path.read_bytes()
                if path.suffix == ".html":
                    text = json.dumps(document_in(text.decode()), indent=1).encode()
                found[path.relative_to(out).as_posix()] = text.replace(place.encode(), b"PLACE")
        found["stdout"] = done.stdout.replace(place.encode(), b"PLACE")
        found["stderr"] = done.stderr.replace(place.encode(), b"PLACE")
        found["exit code"] = str(done.returncode).encode()
        return found


def _kept(folder: Path, checkout: Path, command: Sequence[str]) -> Said:
    """What a checkout said, from the folder in which that is kept, where it is there."""
    key = hashlib.sha256(json.dumps([str(checkout.resolve()), *command]).encode()).hexdigest()[:24]
    place = folder / f"{key}.json"
    if place.is_file():
        return Said(
            {name: text.encode("latin-1") for name, text in json.loads(place.read_text(encoding="utf-8")).items()}
        )
    found = said(checkout, command)
    folder.mkdir(parents=True, exist_ok=True)
    place.write_text(json.dumps({name: text.decode("latin-1") for name, text in found.items()}), encoding="utf-8")
    return found


class Substitution:
    """`s/was/is/`, as sed has it: what a difference that is meant does to the older text."""

    def __init__(self, text: str) -> None:
        if len(text) < 4 or text[0] != "s" or len(parts := text[2:].split(text[1])) != 3 or parts[2]:
            raise argparse.ArgumentTypeError(f"not of the form s/was/is/: {text}")
        self.was = re.compile(parts[0].encode())
        self.now = parts[1].encode()

    def __call__(self, text: bytes) -> bytes:
        """The text as it should be now."""
        return self.was.sub(self.now, text)


def differences(
    old: Said, new: Said, allowed: Iterable[Substitution], ignored: Iterable[re.Pattern[bytes]]
) -> Iterator[str]:
    """What differs, one text for each file."""
    for name in sorted({*old, *new}):
        before, after = old.get(name), new.get(name)
        if before is None or after is None:
            yield f"{name}: {'gone' if after is None else 'new'}"
            continue
        for change in allowed:
            before = change(before)
        for each in ignored:
            before, after = each.sub(b"", before), each.sub(b"", after)
        if before != after:
            lines = difflib.unified_diff(
                before.decode(errors="replace").splitlines(),
                after.decode(errors="replace").splitlines(),
                lineterm="",
                n=0,
            )
            shown = [line[:300] for line in lines if not line.startswith(("---", "+++", "@@"))]
            rest = [f"… and {len(shown) - _LINES} more lines"] if len(shown) > _LINES else []
            yield "\n    ".join([f"{name}: differs", *shown[:_LINES], *rest])


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare, and say what differs."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--each", action="append", type=Path, default=[], metavar="DIR", help="each folder in DIR")
    parser.add_argument("--every", action="store_true", help="every command, not only extract")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="where what OLD said is kept")
    parser.add_argument("--allow", action="append", type=Substitution, default=[], metavar="s/WAS/IS/")
    parser.add_argument("--ignore", action="append", type=lambda s: re.compile(s.encode()), default=[], metavar="REGEX")
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args(arguments)
    folders = [*given.folders, *(p for each in given.each for p in sorted(each.iterdir()) if p.is_dir())]
    asked = [(folder, *each) for folder in folders for each in _commands(str(folder.resolve()), every=given.every)]

    def compared(one: tuple[Path, str, list[str]]) -> list[str]:
        _, _, command = one
        old = _kept(given.keep, given.old, command) if given.keep else said(given.old, command)
        return list(differences(old, said(given.new, command), given.allow, given.ignore))

    different = 0
    with ThreadPoolExecutor(given.jobs) as pool:
        for (folder, label, _), found in zip(asked, pool.map(compared, asked), strict=True):
            different += bool(found)
            for text in found:
                print(f"{folder.name} · {label}: {text}", flush=True)
    print(f"{len(asked)} commands on {len(folders)} folders: {different or 'none'} differ")
    return 1 if different else 0


if __name__ == "__main__":
    raise SystemExit(main())
