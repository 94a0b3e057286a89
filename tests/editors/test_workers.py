# SPDX-License-Identifier: Apache-2.0
"""What if a process that analyses says nonsense, or dies?"""

from __future__ import annotations

import asyncio
import sys
from typing import Any

from rosward.lsp.workers import Crew, Hands

DIES = """import sys
sys.stdin.readline()
print("nonsense"); print("[1]"); print('{"view": [1]}'); print('{"log": "told"}')
sys.stderr.write("complaint\\n")
"""
ANSWERS = """import json, sys
for line in sys.stdin:
    question = json.loads(line)
    print(json.dumps({"echo": question}), flush=True)
    print(json.dumps({"done": question["renew"], "names": []}), flush=True)
"""


def _logs(told: list[dict[str, Any]]) -> list[str]:
    return [document["log"] for document in told if "log" in document]


def test_a_process_that_dies_is_started_again_a_few_times() -> None:
    told: list[dict[str, Any]] = []

    async def work() -> None:
        hands = Hands([sys.executable, "-c", DIES], 0.0, told.append)
        hands.change(None)
        while hands.busy:
            await asyncio.sleep(0.01)
        await hands.end()

    asyncio.run(work())
    logs = _logs(told)
    assert sum("has ended (status 0)" in line for line in logs) == 5
    assert logs.count("the analysis sent something that is no answer") == 15
    assert logs.count("told") == logs.count("complaint") == 5


def test_a_program_that_is_not_there_is_told() -> None:
    told: list[dict[str, Any]] = []

    async def work() -> None:
        hands = Hands(["/nowhere/rosward"], 0.0, told.append)
        hands.change(None)
        while hands.busy:
            await asyncio.sleep(0.01)
        await hands.end()

    asyncio.run(work())
    assert "cannot be started" in _logs(told)[0]


def test_only_what_is_new_is_sent_and_changes_within_a_moment_are_one() -> None:
    told: list[dict[str, Any]] = []

    async def settled(crew: Crew) -> None:
        while crew.busy:
            await asyncio.sleep(0.01)

    async def work() -> None:
        crew = Crew([([sys.executable, "-c", ANSWERS], 0.05)], lambda _index, document: told.append(document))
        crew.change(None)
        await settled(crew)
        crew.show("/a.py", "one")
        crew.show("/a.py", "two")
        crew.show("/b.py", "three")
        await settled(crew)
        crew.change(["/c.py"])
        await settled(crew)
        crew.show("/a.py", None)
        await settled(crew)
        await crew.end()

    asyncio.run(work())
    asked = [(d["echo"]["texts"], d["echo"]["changed"]) for d in told if "echo" in d]
    assert asked == [
        ({}, None),
        ({"/a.py": "two", "/b.py": "three"}, ["/a.py", "/b.py"]),
        ({}, ["/c.py"]),
        ({"/a.py": None}, ["/a.py"]),
    ]
