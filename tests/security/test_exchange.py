# SPDX-License-Identifier: Apache-2.0
"""Promise: data flows where our policies let it, and nowhere else; what was signed cannot be changed.

Each participant is a process of its own on the loopback interface. alice and bob have our permissions, eve and mallory
have no security at all. That eve and mallory hear each other shows that they could have heard more.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import pytest
from outputs.networks import node, pub, sub

from rosward import Network, Resolution
from rosward.network.connect import connect
from rosward.outputs.policies.permissions import permissions_xml

from .cyclone import Cyclone, DdsError
from .keystore import Keystore

_TESTS: Final = Path(__file__).parent.parent
_PATIENCE: Final = 300.0
_LONGER: Final = 1.0
"""How long those who must hear nothing may still listen, after all others have heard each other."""

HOLE = Resolution.PATTERN


def network() -> Network:
    return connect(
        "jazzy",
        [
            node("/alice", pub("/chatter"), pub("/robot_*/cmd", resolution=HOLE), sub("/answer")),
            node("/bob", sub("/chatter"), sub("/robot_3/cmd"), pub("/answer"), pub("/only_bob")),
            node("/carol", pub("/other"), sub("/only_bob")),
        ],
    )


class Peer:
    """A running `peer.py`."""

    def __init__(self, name: str, domain: int, enclave: Path | None, write: list[str], read: list[str]) -> None:
        given = {"name": name, "domain": domain, "enclave": enclave and str(enclave), "write": write, "read": read}
        search = os.pathsep.join([str(_TESTS), *sys.path])
        self._process = subprocess.Popen(
            [sys.executable, "-m", "security.peer", json.dumps(given)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env={**os.environ, "PYTHONPATH": search},
        )
        self.heard: set[tuple[str, str]] = set()
        self.matched: dict[str, int] = {}
        self.refused = ""
        self._told: queue.Queue[dict[str, Any]] = queue.Queue()
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def _listen(self) -> None:
        assert self._process.stdout
        for line in self._process.stdout:
            self._told.put(json.loads(line))

    def hears(self, sender: str, topic: str, patience: float = _PATIENCE) -> bool:
        """Whether a sample of that sender comes in on that topic in time."""
        end = time.monotonic() + patience
        while (sender, topic) not in self.heard and time.monotonic() < end:
            with contextlib.suppress(queue.Empty):
                self._note(self._told.get(timeout=0.05))
        return (sender, topic) in self.heard

    def refusal(self) -> str:
        """Why it ended by itself."""
        self._process.wait(_PATIENCE)
        self.end()
        return self.refused

    def _note(self, told: dict[str, Any]) -> None:
        if "heard" in told:
            self.heard.add((told["heard"], told["topic"]))
        self.matched = told.get("matched", self.matched)
        self.refused = told.get("refused", self.refused)

    def end(self) -> None:
        """Let it tell the rest."""
        assert self._process.stdin
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.close()
        try:
            self._process.wait(_PATIENCE)
        finally:
            self._process.kill()
        self._listener.join(_PATIENCE)
        while not self._told.empty():
            self._note(self._told.get())


@contextlib.contextmanager
def talking(*peers: Peer) -> Iterator[None]:
    try:
        yield
    finally:
        for peer in peers:
            peer.end()


def enclave(keystore: Keystore, name: str, **more: Any) -> Path:
    return keystore.enclave(f"/{name}", permissions_xml(network(), f"/{name}", keystore.domain, **more))


def test_data_flows_where_the_policy_lets_it_and_nowhere_else(keystore: Keystore) -> None:
    topics = ["rt/chatter", "rt/robot_3/cmd"]
    alice = Peer("alice", keystore.domain, enclave(keystore, "alice"), topics, ["rt/answer"])
    bob = Peer("bob", keystore.domain, enclave(keystore, "bob"), ["rt/answer", "rt/only_bob"], topics)
    both = ["rt/chatter", "rt/answer", "rt/robot_3/cmd", "rt/aside"]
    eve = Peer("eve", keystore.domain, None, [], both)
    mallory = Peer("mallory", keystore.domain, None, both, [])
    with talking(alice, bob, eve, mallory):
        assert bob.hears("alice", "rt/chatter")
        assert bob.hears("alice", "rt/robot_3/cmd")
        assert alice.hears("bob", "rt/answer")
        assert eve.hears("mallory", "rt/aside")
        time.sleep(_LONGER)
    assert alice.heard == {("bob", "rt/answer")}
    assert bob.heard == {("alice", "rt/chatter"), ("alice", "rt/robot_3/cmd")}
    assert eve.heard == {("mallory", topic) for topic in both}
    assert bob.matched == {"read rt/chatter": 1, "read rt/robot_3/cmd": 1, "write rt/answer": 1, "write rt/only_bob": 0}
    assert mallory.matched == dict.fromkeys((f"write {topic}" for topic in both), 1)


@pytest.mark.parametrize(("write", "read"), [(["rt/other"], []), ([], ["rt/chatter"]), (["rt/robot_3/cmdx"], [])])
def test_a_peer_that_asks_for_more_is_refused(write: list[str], read: list[str], keystore: Keystore) -> None:
    alice = Peer("alice", keystore.domain, enclave(keystore, "alice"), write, read)
    assert "-13" in alice.refusal()


def test_a_policy_of_another_authority_does_not_match(keystore: Keystore, tmp_path: Path) -> None:
    """Whoever signs permissions for themselves may do anything on their own machine, and nobody listens."""
    alice = Peer("alice", keystore.domain, enclave(keystore, "alice"), ["rt/chatter"], ["rt/answer"])
    bob = Peer("bob", keystore.domain, enclave(keystore, "bob"), ["rt/answer"], ["rt/chatter"])
    foreign = Keystore(tmp_path / "foreign", keystore.domain)
    rogue = Peer("rogue", keystore.domain, enclave(foreign, "alice"), ["rt/chatter"], ["rt/answer"])
    with talking(alice, bob, rogue):
        assert bob.hears("alice", "rt/chatter")
        assert alice.hears("bob", "rt/answer")
        time.sleep(_LONGER)
    assert bob.heard == {("alice", "rt/chatter")}
    assert rogue.heard == set()
    assert set(rogue.matched.values()) == {0}


def refusal(dds: Cyclone, domain: int, folder: Path) -> str:
    with pytest.raises(DdsError) as caught, dds.participant(domain, folder):
        pass
    return str(caught.value)


def test_what_was_signed_cannot_be_changed(dds: Cyclone, keystore: Keystore) -> None:
    folder = enclave(keystore, "carol")
    with dds.participant(keystore.domain, folder):
        pass
    signed = folder / "permissions.p7s"
    signed.write_bytes(signed.read_bytes().replace(b"rt/other", b"rt/chatter"))
    assert "digest failure" in refusal(dds, keystore.domain, folder)


@pytest.mark.parametrize(
    ("not_before", "not_after"),
    [("2020-01-01T00:00:00", "2021-01-01T00:00:00"), ("2049-01-01T00:00:00", "2049-12-31T23:59:59")],
    ids=["expired", "not yet valid"],
)
def test_permissions_hold_in_their_time_only(not_before: str, not_after: str, dds: Cyclone, keystore: Keystore) -> None:
    folder = enclave(keystore, "carol", not_before=not_before, not_after=not_after)
    assert "ermission" in refusal(dds, keystore.domain, folder)


def test_permissions_hold_for_their_enclave_only(dds: Cyclone, keystore: Keystore) -> None:
    stolen = keystore.enclave("/carol", permissions_xml(network(), "/bob", keystore.domain))
    assert "Subject name is invalid" in refusal(dds, keystore.domain, stolen)


def test_permissions_hold_in_their_domain_only(dds: Cyclone, keystore: Keystore) -> None:
    other = keystore.enclave("/carol", permissions_xml(network(), "/carol", keystore.domain + 1))
    assert "not allowed to create participant" in refusal(dds, keystore.domain, other)
