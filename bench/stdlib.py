# SPDX-License-Identifier: Apache-2.0
"""Analyses the running Python's whole standard library: no crash, nothing over a limit or unreadable in silence.

    python bench/stdlib.py [--seconds N] [OPTION_OF_EXTRACT…]

Exit status 1 after a crash, or where a file that does not parse has no finding.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import sysconfig
import tempfile
from collections import Counter
from pathlib import Path

from measure import extract
from sites import parses


def main() -> int:
    """Copy the library, analyse the copy, print cost and findings."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--seconds", type=float, default=1800, help="time limit")
    options, further = parser.parse_known_args()
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder, "Lib")
        ignored = shutil.ignore_patterns("site-packages", "dist-packages", "__pycache__", "config-*", "*.so")
        shutil.copytree(sysconfig.get_path("stdlib"), library, ignore=ignored)
        files = [path for path in sorted(library.rglob("*.py")) if path.is_file()]
        extraction = extract([library], seconds=options.seconds, options=["--tests", *further])
        broken = {path.relative_to(library).as_posix() for path in files if not parses(path)}
    run, graph = extraction.run, extraction.graph
    print(f"{len(files)} files, {run.wall:.1f} s ({run.cpu:.1f} s CPU), {run.peak_mb:.0f} MB, exit status {run.status}")
    if extraction.trouble or graph is None:
        print(run.output[-4000:])
        print(extraction.trouble)
        return 1
    spoken_of = {finding.spot[0] for finding in graph.findings}
    for code, number in sorted(Counter(finding.code for finding in graph.findings).items()):
        print(f"  {code} {number}")
    for finding in graph.findings:
        if finding.severity == "error":
            print(f"  {finding.spot[0]}:{finding.spot[1]}: {finding.code} {finding.message}")
    print(f"{len(graph.nodes)} nodes, {sum(not entity.system for entity in graph.entities)} entities")
    silent = sorted(broken - spoken_of)
    print(f"{len(broken)} files do not parse, {len(silent)} of them without a finding {silent[:20]}")
    return 1 if silent else 0


if __name__ == "__main__":
    sys.exit(main())
