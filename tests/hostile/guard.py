# SPDX-License-Identifier: Apache-2.0
"""What does a run of rosward do to the machine? A process of its own in which every event that could harm is written down.

    watched(["extract", str(ws), "-o", str(out)], inputs=ws, outputs=out)  ->  Watched(status=1, events=[], stdout='…', stderr='…')

Python tells an audit hook of each file that is opened, each program that is started, each socket and each text that is compiled.
An event is harm if it writes outside of the output folder and of rosward's own cache folder, starts a program other than the
renderer of pictures, touches the network, or runs text of the input. Memory and time are bounded by the operating system.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final, NamedTuple

SECONDS: Final = 120
HANGING: Final = 1_800
"""So long may it wait for what never comes; how long it works is counted in time of the processor."""
MEGABYTES: Final = 3_000

_PROGRAM: Final = r"""
import sys
sys.path[:] = [p for p in sys.path if p]  # -c puts the current folder first, which the command does not
import json, os, resource
log, inputs, outputs, megabytes, file_bytes, seconds = sys.argv[1:7]
inputs = os.path.realpath(inputs)
outputs = os.path.realpath(outputs)
kept = os.path.realpath(os.environ["ROSWARD_CACHE"])
if hasattr(os, "sched_setaffinity"):  # with one core there are no workers: nobody would hear what they do
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
events = []

def inside(path, folder):
    try:
        path = os.path.realpath(os.fsdecode(path))
    except (TypeError, ValueError):
        return False
    return path == folder or path.startswith(folder + os.sep)

def is_own(path):
    return inside(path, outputs) or inside(path, kept)

WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
CHANGES = {"os.remove", "os.rmdir", "os.mkdir", "os.chmod", "os.chown", "os.truncate", "os.utime", "os.link", "os.symlink", "os.rename",
           "os.setxattr", "os.removexattr", "shutil.rmtree", "shutil.move", "shutil.copyfile"}
STARTS = {"os.system", "os.exec", "os.posix_spawn", "os.spawn", "os.startfile", "os.fork", "os.forkpty", "pty.spawn", "ctypes.dlopen"}

def hook(name, args):
    if name == "open":
        path, mode, flags = args
        if isinstance(path, int) or path is None:
            return
        if flags & WRITING and not is_own(path) and os.fsdecode(path) not in ("/dev/null",):
            events.append([name, os.fsdecode(path)])
    elif name in CHANGES:
        paths = [a for a in args if isinstance(a, (str, bytes))]
        if not all(is_own(p) or is_own(os.path.dirname(p) or ".") for p in paths):
            events.append([name, repr(args)])
    elif name == "subprocess.Popen":
        program = args[0] if isinstance(args[0], str) else os.fsdecode(args[0])
        if os.path.basename(program) != "graphviz-pure" or inside(program, inputs):
            events.append([name, repr(args[1])])
    elif name in STARTS:
        events.append([name, repr(args)[:300]])
    elif name.startswith("socket.") or name.startswith(("urllib.", "http.", "ftplib.", "smtplib.", "webbrowser.")):
        events.append([name, repr(args)[:300]])
    elif name == "exec":
        file = getattr(args[0], "co_filename", "")
        caller = sys._getframe(1).f_code.co_filename
        if inside(file, inputs) if os.path.isabs(file) else os.sep + "rosward" + os.sep in caller:
            events.append([name, file, caller])
    elif name == "import":
        if any(inside(p, inputs) for p in (args[1],) if isinstance(p, str)):
            events.append([name, repr(args[:2])])
    elif name in ("pickle.find_class", "marshal.loads", "marshal.load") and name.startswith("pickle"):
        events.append([name, repr(args)])

from rosward.cli import main
limit = int(megabytes) << 20
resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), resource.RLIM_INFINITY))
if int(file_bytes):
    resource.setrlimit(resource.RLIMIT_FSIZE, (int(file_bytes), int(file_bytes)))
sys.addaudithook(hook)
status = None
try:
    status = main(sys.argv[7:])
except SystemExit as leaving:
    status = leaving.code
finally:
    sys.stdout.flush()
    told = json.dumps({"status": status, "events": events, "megabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024,
                       "seconds": sum(resource.getrusage(resource.RUSAGE_SELF)[:2]),
                       "loaded": [m for m, x in list(sys.modules.items()) if inside(getattr(x, "__file__", None) or "/", inputs)]})
    os.write(int(log), told.encode())
"""


class Watched(NamedTuple):
    """What a run did: `events` are those that harm, `loaded` the modules that were imported from the input."""

    status: int | None
    events: list[list[str]]
    loaded: list[str]
    stdout: str
    stderr: str
    megabytes: int
    seconds: float


def watched(
    arguments: Sequence[str],
    *,
    inputs: Path,
    outputs: Path,
    seconds: float = SECONDS,
    megabytes: int = MEGABYTES,
    file_bytes: int = 0,
    environment: Mapping[str, str] | None = None,
    folder: Path | None = None,
) -> Watched:
    """Run the command under watch; `file_bytes` bounds the size of a file that it writes, `folder` is where it stands."""
    read, write = os.pipe()
    limits = [str(write), str(inputs), str(outputs), str(megabytes), str(file_bytes), str(math.ceil(seconds))]
    try:
        done = subprocess.run(
            [sys.executable, "-c", _PROGRAM, *limits, *arguments],
            capture_output=True,
            timeout=HANGING,
            check=False,
            pass_fds=(write,),
            cwd=folder,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p), **(environment or {})},
        )
    finally:
        os.close(write)
        with os.fdopen(read, "rb") as report:
            told = report.read()
    stderr = done.stderr.decode(errors="replace")
    assert told, stderr[-2000:] or f"ended by {done.returncode}"
    found = json.loads(told)
    assert "Traceback" not in stderr, stderr[-3000:]
    return Watched(
        found["status"],
        found["events"],
        found["loaded"],
        done.stdout.decode(errors="replace"),
        stderr,
        found["megabytes"],
        found["seconds"],
    )


def harmless(run: Watched) -> Watched:
    """The run itself, once it is sure that it did no harm and ended as the command line says."""
    assert run.events == []
    assert run.loaded == []
    assert run.status in (0, 1, 2), run
    return run
