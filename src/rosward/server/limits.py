# SPDX-License-Identifier: Apache-2.0
"""How much may somebody hand in, and how much may an analysis take? Every bound of the server, in one record.

An upload beyond a bound is refused as a whole, with the bound in the message; an analysis beyond one is ended.
"""

from __future__ import annotations

from rosward.records import NamedTuple

__all__ = ["Limits"]

_MEGABYTE = 1024 * 1024


class Limits(NamedTuple):
    """Bounds.

    `upload`: bytes of one request. `file`: bytes of one file. `files`: files of one upload. `unpacked`: bytes of all of them.
    `ratio`: how much smaller than its content an entry of a zip may be. `depth`: folders within each other. `name`: bytes of a path.
    `memory`: bytes of address space of an analysis, 512 MB of which are reserved for its stack. `seconds`: time of an analysis.
    `workers`: analyses at a time. `waiting`: further ones in the queue. `results`: results that are kept. `watched`: workspaces that are watched.
    `streams`: pages that get news at the same time. `uploads`: uploads at the same time. `silence`: seconds without a byte after which a
    request is given up. `sending`: seconds after which an upload is given up, however slowly it comes.
    """

    upload: int = 64 * _MEGABYTE
    file: int = 8 * _MEGABYTE
    files: int = 20_000
    unpacked: int = 256 * _MEGABYTE
    ratio: int = 200
    depth: int = 40
    name: int = 1_000
    memory: int = 4_096 * _MEGABYTE
    seconds: float = 600.0
    workers: int = 2
    waiting: int = 8
    results: int = 20
    watched: int = 4
    streams: int = 24
    uploads: int = 8
    silence: float = 30.0
    sending: float = 600.0
