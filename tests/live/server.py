# SPDX-License-Identifier: Apache-2.0
"""Runs programs under the real rclpy, many in a second: everything is imported once, each program runs in a fork of its own.

    {"folder": "/tmp/p", "start": "main.py", …}    a line on the standard input, for one program
    {"facts": […], "nodes": […], "end": "normal", …}    a line on the standard output, when it has ended

Nothing leaves the machine: the programs run in a network namespace of their own where that is permitted, else on localhost only.
"""

from __future__ import annotations

import atexit
import contextlib
import ctypes
import fcntl
import importlib
import json
import os
import runpy
import signal
import socket
import struct
import sys
import threading
import time
import traceback
from pathlib import Path
from typing import Any, Final

import rclpy
import rclpy.action
import rclpy.executors
import rclpy.lifecycle
import rclpy.parameter_client
import rclpy.wait_for_message
from rclpy.node import Node

from .recorder import Recorder
from .world import World

_NEW_NETWORK: Final = 0x40000000  # CLONE_NEWNET
_NEW_MOUNTS: Final = 0x00020000  # CLONE_NEWNS
_PRIVATE: Final = 0x44000  # MS_REC | MS_PRIVATE
_IMPORTED: Final = ("rosgraph_msgs.msg", "sensor_msgs.msg", "std_msgs.msg", "std_srvs.srv", "test_msgs.action", "yaml")


def serve() -> None:
    """Answer until the standard input ends."""
    _stay_alone()
    for module in _IMPORTED:
        importlib.import_module(module)
    for number, line in enumerate(sys.stdin):
        print(json.dumps(_in_a_fork(json.loads(line), number % 90 + 1)), flush=True)


def _stay_alone() -> None:
    os.environ.update(ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST", FASTDDS_BUILTIN_TRANSPORTS="UDPv4")
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(_NEW_NETWORK | _NEW_MOUNTS) != 0:
        return
    libc.mount(b"none", b"/", None, _PRIVATE, None)
    libc.mount(b"tmpfs", b"/dev/shm", b"tmpfs", 0, None)  # what ended programs leave there goes with the server
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:  # `ip link set lo up`
        request = bytearray(struct.pack("16sH22x", b"lo", 0))
        fcntl.ioctl(any_socket, 0x8913, request)
        flags = struct.unpack_from("H", request, 16)[0]
        struct.pack_into("H", request, 16, flags | 1)
        fcntl.ioctl(any_socket, 0x8914, request)


def _in_a_fork(job: dict[str, Any], domain: int) -> dict[str, Any]:
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        _run(job, domain, writing)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        answer = pipe.read()
    _, status = os.waitpid(child, 0)
    if not answer:
        return {"facts": [], "nodes": [], "end": f"died ({status})", "errors": [], "output": ""}
    return dict(json.loads(answer))


class _Report:
    """Writes what was seen, once, and ends the process without another word."""

    def __init__(self, writing: int, recorder: Recorder, world: World, output: Path) -> None:
        self.parts = (writing, recorder, world, output)
        self.lock = threading.Lock()

    def close(self, end: str) -> None:
        """Report and leave."""
        writing, recorder, world, output = self.parts
        with self.lock:
            recorder.read_all()
            sys.stdout.flush()
            report = {
                "facts": recorder.told(),
                "nodes": sorted(recorder.nodes),
                "end": end,
                "errors": world.errors[:20],
                "output": output.read_text(errors="replace")[-4000:],
            }
            with os.fdopen(writing, "w") as pipe:
                pipe.write(json.dumps(report))
            os._exit(0)


def _run(job: dict[str, Any], domain: int, writing: int) -> None:
    folder = Path(job["folder"])
    output = folder / ".output"
    os.chdir(folder)
    for target, flags in ((0, os.O_RDONLY), (1, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), (2, os.O_WRONLY | os.O_APPEND)):
        os.dup2(os.open("/dev/null" if target == 0 else output, flags, 0o600), target)
    sys.stdin = os.fdopen(os.dup(0))
    os.environ.update(job.get("environment", {}), ROS_DOMAIN_ID=str(domain), ROS_LOG_DIR=str(folder / ".log"))
    sys.argv = [job["start"], *job.get("arguments", [])]
    sys.path[:0] = [str(folder / p) for p in job.get("path", ["."])]
    recorder = Recorder()
    world = World(recorder, interrupt=bool(job.get("interrupt")))
    report = _Report(writing, recorder, world, output)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    threading.Thread(target=_watch, args=(report, time.sleep, job["patience"]), daemon=True).start()
    recorder.install()
    world.install()
    end = "normal"
    try:
        _start(job["start"])
        for thread in threading.enumerate():
            if thread is not threading.main_thread() and not thread.daemon:
                thread.join(0.5)
        world.happen()
        atexit._run_exitfuncs()
    except SystemExit as error:
        end = "normal" if error.code in {None, 0} else f"SystemExit: {error.code}"
    except BaseException as error:
        traceback.print_exc()
        end = f"{type(error).__name__}: {error}"
        with contextlib.suppress(BaseException):
            world.happen()
    report.close(end)


def _watch(report: _Report, sleep: Any, patience: float) -> None:
    sleep(patience)
    os.kill(os.getpid(), signal.SIGINT)
    sleep(patience / 2)
    report.close("does not end")


def _start(what: str) -> None:
    """`main.py` is run as a script, `package.module:function` is called, `class:module` is instantiated."""
    if what.endswith(".py"):
        runpy.run_path(what, run_name="__main__")
        return
    module, _, name = what.partition(":")
    if module == "class":
        _instantiate(importlib.import_module(name))
        return
    getattr(importlib.import_module(module), name)()


def _instantiate(module: Any) -> None:
    """Each node class of a module from which no other one of it is derived."""
    if not rclpy.ok():  # the module may have done so
        rclpy.init()
    classes = [
        c
        for c in vars(module).values()
        if isinstance(c, type) and issubclass(c, Node) and c.__module__ == module.__name__
    ]
    made = [c() for c in classes if not any(c is not other and issubclass(other, c) for other in classes)]
    for node in made:
        rclpy.spin(node)


if __name__ == "__main__":
    serve()
