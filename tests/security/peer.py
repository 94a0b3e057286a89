# SPDX-License-Identifier: Apache-2.0
"""A participant in a process of its own: it writes and reads until its standard input ends, and tells what it saw.

python -m security.peer '{"name": "bob", "domain": 7, "enclave": "/tmp/…/bob", "write": [], "read": ["rt/chatter"]}'
  ->  {"heard": "alice", "topic": "rt/chatter"}     at the first sample of each sender on each topic
      {"matched": {"read rt/chatter": 1}}           at the end
      {"refused": "dds_create_participant: -1 …"}   instead of all that, where security refuses it
"""

from __future__ import annotations

import json
import select
import sys
from pathlib import Path
from typing import Any, Final

from .cyclone import Cyclone, DdsError
from .endpoints import Endpoint

STRING: Final = "std_msgs::msg::dds_::String_"
_PAUSE: Final = 0.05


def _tell(**words: Any) -> None:
    print(json.dumps(words), flush=True)


def _talk(given: dict[str, Any]) -> None:
    enclave = Path(given["enclave"]) if given["enclave"] else None
    with Cyclone().participant(given["domain"], enclave) as participant:
        writers = {t: participant.open(Endpoint("write", t, STRING)) for t in given["write"]}
        readers = {t: participant.open(Endpoint("read", t, STRING)) for t in given["read"]}
        most: dict[str, int] = {}
        heard: set[tuple[str, str]] = set()
        while not select.select([sys.stdin], [], [], _PAUSE)[0]:
            for topic, writer in writers.items():
                writer.write(given["name"])
                most[f"write {topic}"] = max(most.get(f"write {topic}", 0), writer.matched())
            for topic, reader in readers.items():
                most[f"read {topic}"] = max(most.get(f"read {topic}", 0), reader.matched())
                for sender in reader.take():
                    if (sender, topic) not in heard:
                        heard.add((sender, topic))
                        _tell(heard=sender, topic=topic)
        _tell(matched=most)


if __name__ == "__main__":
    try:
        _talk(json.loads(sys.argv[1]))
    except DdsError as refused:
        _tell(refused=str(refused))
