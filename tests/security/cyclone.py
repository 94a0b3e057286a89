# SPDX-License-Identifier: Apache-2.0
"""What does a real DDS with DDS Security say? Cyclone DDS of Debian (`libddsc0debian`), called by ctypes.

    with Cyclone().participant(7, Path("keystore/talker")) as talker:
        talker.may(Endpoint("write", "rt/chatter", "std_msgs::msg::dds_::String_"))   -> True
        talker.may(Endpoint("write", "rt/evil", "std_msgs::msg::dds_::String_"))      -> False

Only what the tests need is bound: participants with and without security, writers and readers of one string, what they
match, and the endpoints of other participants as discovery tells of them (the topics DCPSPublication and
DCPSSubscription). Everything goes over the loopback interface. The structures are those of Cyclone DDS 0.10.
"""

from __future__ import annotations

import contextlib
import ctypes as c
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, Final

from .endpoints import Endpoint

__all__ = ["Channel", "Cyclone", "DdsError", "Participant", "UnavailableError"]

_LIBRARY: Final = "libddsc.so.0debian"
_PLUGINS: Final = "libddsc0debian"
_CONFIGURATION: Final = """\
<General>
  <Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>
  <AllowMulticast>false</AllowMulticast>
</General>
<Discovery>
  <ParticipantIndex>auto</ParticipantIndex>
  <MaxAutoParticipantIndex>30</MaxAutoParticipantIndex>
  <Peers><Peer address="127.0.0.1"/></Peers>
</Discovery>
"""
_NOT_ALLOWED: Final = -13  # DDS_RETCODE_NOT_ALLOWED_BY_SECURITY
_RELIABLE, _TRANSIENT_LOCAL, _SECOND = 1, 1, 1_000_000_000
_PUBLICATIONS, _SUBSCRIPTIONS = 0x7FFF0003, 0x7FFF0004  # pseudo handles of the built-in topics
_AT_ONCE: Final = 64
_MOMENT: Final = 0.1
_PLUGIN_FILES: Final = (
    ("auth", "authentication", "auth"),
    ("crypto", "crypto", "crypto"),
    ("access", "access_control", "ac"),
)
_FILES: Final = (
    ("dds.sec.auth.identity_ca", "identity_ca.cert.pem"),
    ("dds.sec.auth.identity_certificate", "cert.pem"),
    ("dds.sec.auth.private_key", "key.pem"),
    ("dds.sec.access.permissions_ca", "permissions_ca.cert.pem"),
    ("dds.sec.access.governance", "governance.p7s"),
    ("dds.sec.access.permissions", "permissions.p7s"),
)


class UnavailableError(Exception):
    """This machine has no Cyclone DDS with the security plugins."""


class DdsError(Exception):
    """A call of Cyclone DDS failed; `log` is what it wrote meanwhile."""

    def __init__(self, call: str, code: int, log: list[str]) -> None:
        super().__init__(f"{call}: {code}\n" + "\n".join(log))
        self.code = code
        self.log = log


class _Sequence(c.Structure):
    _fields_ = [("data", c.c_void_p), ("size", c.c_uint32)]


class _Descriptor(c.Structure):
    """`dds_topic_descriptor_t`."""

    _fields_ = [
        ("size", c.c_uint32),
        ("align", c.c_uint32),
        ("flags", c.c_uint32),
        ("number_of_keys", c.c_uint32),
        ("type_name", c.c_char_p),
        ("keys", c.c_void_p),
        ("number_of_operations", c.c_uint32),
        ("operations", c.POINTER(c.c_uint32)),
        ("meta", c.c_char_p),
        ("type_information", _Sequence),
        ("type_mapping", _Sequence),
        ("restrict_representation", c.c_uint32),
    ]


class _Text(c.Structure):
    """The one type of all topics here: a string. Discovery and permissions look at names only."""

    _fields_ = [("data", c.c_char_p)]


class _Matched(c.Structure):
    _fields_ = [
        ("total", c.c_uint32),
        ("total_change", c.c_int32),
        ("current", c.c_uint32),
        ("current_change", c.c_int32),
        ("last", c.c_uint64),
    ]


class _SampleInfo(c.Structure):
    _fields_ = [
        ("sample_state", c.c_uint),
        ("view_state", c.c_uint),
        ("instance_state", c.c_uint),
        ("valid", c.c_bool),
        ("timestamp", c.c_int64),
        ("instance", c.c_uint64),
        ("publication", c.c_uint64),
        ("ranks", c.c_uint32 * 5),
    ]


class _RemoteEndpoint(c.Structure):
    """`dds_builtintopic_endpoint_t`."""

    _fields_ = [
        ("key", c.c_ubyte * 16),
        ("participant", c.c_ubyte * 16),
        ("participant_instance", c.c_uint64),
        ("topic", c.c_char_p),
        ("type", c.c_char_p),
        ("qos", c.c_void_p),
    ]


class _LogData(c.Structure):
    _fields_ = [
        ("priority", c.c_uint32),
        ("domain", c.c_uint32),
        ("file", c.c_char_p),
        ("function", c.c_char_p),
        ("line", c.c_uint32),
        ("message", c.c_char_p),
        ("size", c.c_size_t),
        ("header", c.c_size_t),
    ]


_Sink = c.CFUNCTYPE(None, c.c_void_p, c.POINTER(_LogData))
_OPERATIONS = (c.c_uint32 * 3)((1 << 24) | (5 << 16), 0, 0)  # one string at offset 0; the end


def _descriptor(type_name: str) -> _Descriptor:
    return _Descriptor(8, 8, 0, 0, type_name.encode(), None, 2, _OPERATIONS, b"", _Sequence(), _Sequence(), 0)


class Cyclone:
    """The library, once in a process. `log` is what it says."""

    def __init__(self) -> None:
        try:
            self._library = c.CDLL(_LIBRARY)
        except OSError as error:
            raise UnavailableError(f"{_LIBRARY} (Debian: libddsc0debian): {error}") from None
        folders = sorted(Path("/usr/lib").glob(f"*/{_PLUGINS}"))
        if not folders:
            raise UnavailableError(f"no plugins in /usr/lib/*/{_PLUGINS}")
        self._plugins = folders[0]
        self.log: list[str] = []
        self._sink = _Sink(self._note)
        self._library.dds_set_log_sink(self._sink, None)

    def _note(self, _: object, data: Any) -> None:
        self.log.append((data.contents.message or b"").decode(errors="replace").strip())

    def call(self, function: str, *arguments: object, result: Any = c.c_int32) -> int:
        """Call a function; DdsError where it returns a negative number."""
        called: Any = getattr(self._library, function)
        called.restype = result
        before = len(self.log)
        given = called(*arguments)
        if result is c.c_int32 and given < 0:
            raise DdsError(function, given, self.log[before:])
        return int(given or 0)

    def qos(self, properties: dict[str, str] | None = None) -> c.c_void_p:
        """Reliable and transient local, as in ROS where nothing may be lost, with these properties."""
        made = c.c_void_p(self.call("dds_create_qos", result=c.c_void_p))
        self.call("dds_qset_reliability", made, _RELIABLE, c.c_int64(_SECOND), result=None)
        self.call("dds_qset_durability", made, _TRANSIENT_LOCAL, result=None)
        for name, value in (properties or {}).items():
            self.call("dds_qset_prop", made, name.encode(), value.encode(), result=None)
        return made

    @contextlib.contextmanager
    def participant(self, domain: int, enclave: Path | None = None) -> Iterator[Participant]:
        """A participant with the files of an enclave, or an unsecured one. DdsError where security refuses it.

        The domain goes with it: the access control of Cyclone DDS keeps the permissions of the first participant in a
        domain of a process for all that follow.
        """
        configured = self.call("dds_create_domain", c.c_uint32(domain), _CONFIGURATION.encode())
        try:
            qos = self.qos(self._security(enclave) if enclave else None)
            try:
                handle = self.call("dds_create_participant", c.c_uint32(domain), qos, None)
            finally:
                self.call("dds_delete_qos", qos, result=None)
            yield Participant(self, handle)
        finally:
            self.call("dds_delete", configured)

    def _security(self, enclave: Path) -> dict[str, str]:
        properties = {name: f"file:{enclave.resolve() / file}" for name, file in _FILES}
        for plugin, function, library in _PLUGIN_FILES:
            stem = f"dds.sec.{plugin}.library"
            properties[f"{stem}.path"] = str(self._plugins / f"libdds_security_{library}.so")
            properties[f"{stem}.init"] = f"init_{function}"
            properties[f"{stem}.finalize"] = f"finalize_{function}"
        return properties


class Channel:
    """A writer or a reader."""

    def __init__(self, library: Cyclone, handle: int, *, writes: bool) -> None:
        self._library = library
        self._handle = handle
        self._writes = writes

    def write(self, text: str) -> None:
        """Send one sample."""
        self._library.call("dds_write", self._handle, c.byref(_Text(text.encode())))

    def take(self) -> list[str]:
        """What has come in."""
        return [c.cast(s, c.POINTER(_Text)).contents.data.decode() for s in _taken(self._library, self._handle)]

    def matched(self) -> int:
        """How many writers or readers at the other end this one talks with."""
        status = _Matched()
        function = "dds_get_publication_matched_status" if self._writes else "dds_get_subscription_matched_status"
        self._library.call(function, self._handle, c.byref(status))
        return int(status.current)

    def close(self) -> None:
        """Take it away."""
        self._library.call("dds_delete", self._handle)


class Participant:
    """A participant of a domain."""

    def __init__(self, library: Cyclone, handle: int) -> None:
        self._library = library
        self._handle = handle

    def open(self, endpoint: Endpoint) -> Channel:
        """Make this writer or reader; DdsError where security refuses it, at its topic or at itself."""
        call = self._library.call
        described = _descriptor(endpoint.type)
        qos = self._library.qos()
        try:
            topic = call("dds_create_topic", self._handle, c.byref(described), endpoint.topic.encode(), None, None)
            function = "dds_create_writer" if endpoint.way == "write" else "dds_create_reader"
            try:
                handle = call(function, self._handle, topic, qos, None)
            finally:
                call("dds_delete", topic)  # an endpoint keeps its topic alive
        finally:
            call("dds_delete_qos", qos, result=None)
        return Channel(self._library, handle, writes=endpoint.way == "write")

    def may(self, endpoint: Endpoint) -> bool:
        """Whether security lets this endpoint be made. Any other failure is an error."""
        try:
            self.open(endpoint).close()
        except DdsError as error:
            if error.code != _NOT_ALLOWED:
                raise
            return False
        return True

    def watch(self, until: Callable[[set[Endpoint]], bool], seconds: float) -> set[Endpoint]:
        """The endpoints of the one other participant of which `until` holds; empty where time is up before.

        Once it holds, nothing new may come in for a moment.
        """
        call = self._library.call
        readers = {
            "write": call("dds_create_reader", self._handle, _PUBLICATIONS, None, None),
            "read": call("dds_create_reader", self._handle, _SUBSCRIPTIONS, None, None),
        }
        seen: dict[bytes, set[Endpoint]] = {}
        now = quiet_since = time.monotonic()
        end = now + seconds
        while now < end:
            for way, reader in readers.items():
                for sample in _taken(self._library, reader):
                    remote = c.cast(sample, c.POINTER(_RemoteEndpoint)).contents
                    endpoint = Endpoint(way, remote.topic.decode(), remote.type.decode())
                    seen.setdefault(bytes(remote.participant), set()).add(endpoint)
                    quiet_since = now
            for endpoints in seen.values():
                if until(endpoints) and now - quiet_since > _MOMENT:
                    return endpoints
            time.sleep(0.01)
            now = time.monotonic()
        return set()


def _taken(library: Cyclone, reader: int) -> Iterator[int]:
    """The addresses of what has come in; each is valid until the next is asked for."""
    infos = (_SampleInfo * _AT_ONCE)()
    samples = (c.c_void_p * _AT_ONCE)()
    number = library.call("dds_take", reader, samples, infos, c.c_size_t(_AT_ONCE), c.c_uint32(_AT_ONCE))
    try:
        yield from (samples[index] or 0 for index in range(number) if infos[index].valid)
    finally:
        if number:
            library.call("dds_return_loan", reader, samples, number)
