# SPDX-License-Identifier: Apache-2.0
"""Which inputs of a program change which outputs? Programs are run many times in one process, each time with one input changed.

    {"file": "relay.py", "values": {}}                       a line on the standard input, for one program
    {"changes": [["topic:/in", "topic:/out", 0, "data"]], …}    a line on the standard output

A change is `content` where other contents change what is sent, `arrival` where only leaving the input out does.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any, Final

from .flow_contents import Contents
from .flow_run import Run, Sent, forget, install

VARIANTS: Final = {False: 3, True: 2}
"""How many other contents each input has, in each of the two orders of callbacks."""


def observe(file: str, values: dict[str, list[str]]) -> dict[str, Any]:
    """Run a program in all ways."""
    code = compile(Path(file).read_text(), file, "exec")
    first = Run(file, code, Contents({}, values))
    first.go()
    parameters = {n: v for n, v in first.parameters.items() if v is not None}
    changes: set[tuple[str, str, int, str]] = set()
    sent: set[tuple[str, int]] = set()
    errors = list(first.errors)
    count = void = 0

    def ran(variants: dict[str, int], *, absent: str = "", backward: bool) -> Run:
        contents = Contents(variants, values)
        run = Run(file, code, contents, absent=absent, backward=backward)
        run.overrides = {n: contents.like(f"parameter:{n}", "start", v) for n, v in parameters.items()}
        sent.update(run.go())
        errors.extend(run.errors)
        return run

    for backward, most in VARIANTS.items():
        base = ran({}, backward=backward)
        for source in sorted(base.inputs):
            ways = [({source: n + 1}, "", "content") for n in range(most)]
            if not source.startswith("parameter:") and not backward:
                ways.append(({}, source, "arrival"))
            for variants, absent, how in ways:
                other = ran(variants, absent=absent, backward=backward)
                count += 1
                if base.errors or other.errors:  # an exception that ends a callback is no part of the claim
                    void += 1
                    continue
                changes |= {(source, *sink, how) for sink in _differing(base.output, other.output)}
    forget()
    return {"changes": sorted(changes), "sent": sorted(sent), "runs": count, "void": void, "errors": errors[:5]}


def _differing(ours: Sent, theirs: Sent) -> set[tuple[str, int]]:
    return {sink for sink in {*ours, *theirs} if ours.get(sink) != theirs.get(sink)}


def serve() -> None:
    """Answer until the standard input ends."""
    os.environ.update(ROS_AUTOMATIC_DISCOVERY_RANGE="OFF", FASTDDS_BUILTIN_TRANSPORTS="UDPv4")
    install()
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    for line in sys.stdin:
        job = json.loads(line)
        answers.write(json.dumps(observe(job["file"], job["values"])) + "\n")
        answers.flush()


if __name__ == "__main__":
    serve()
