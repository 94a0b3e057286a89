# SPDX-License-Identifier: Apache-2.0
"""Each record that is kept is read as it was written; what is of another form is refused, whatever it is."""

from __future__ import annotations

import json
from typing import Any, get_args, get_origin, get_type_hints

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sampling import sample

from rosward.cache import codec, records
from rosward.cache.codec import OPTION, PLAIN, TEXT, Codec, MalformedError, loaded, record, text
from rosward.findings import Finding
from rosward.location import Place
from rosward.network.asked import Asked, LaunchAsked
from rosward.network.graph import Action, Network, Service, Topic
from rosward.network.launch_tree import GivenParameter, Inclusion, LaunchEntry, LaunchSystem, Shown
from rosward.ros.entities import Entity, Node, Parameter, Qos
from rosward.ros.flows import End, NodeCall, NodeCallback, NodeFlows, NodeSink
from rosward.rules import RULES

TEXTS = st.text(st.characters(), max_size=6)
"""Halves of surrogate pairs among them: a file name can hold one, and a text of a program two."""

PLAINS = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | TEXTS,
    lambda inner: st.lists(inner, max_size=3),
    max_leaves=4,
)
st.register_type_strategy(str, TEXTS)
st.register_type_strategy(object, PLAINS)
FINDINGS = st.builds(Finding, code=st.sampled_from(sorted(RULES)))
st.register_type_strategy(Finding, FINDINGS)

CODECS: dict[type[Any], Codec[Any]] = {
    Place: records.PLACE,
    Finding: records.FINDING,
    Qos: records.QOS,
    Entity: records.ENTITY,
    Parameter: records.PARAMETER,
    End: records.END,
    NodeCall: records.CALL,
    NodeSink: records.SINK,
    NodeCallback: records.CALLBACK,
    NodeFlows: records.FLOWS,
    Node: records.NODE,
    Topic: records.TOPIC,
    Service: records.SERVICE,
    Action: records.ACTION,
    LaunchAsked: records.LAUNCH_ASKED,
    Asked: records.ASKED,
    Network: records.NETWORK,
    Shown: records.SHOWN,
    GivenParameter: records.GIVEN,
    Inclusion: records.INCLUSION,
    LaunchEntry: records.LAUNCH_ENTRY,
    LaunchSystem: records.LAUNCH_SYSTEM,
}


def _any_of(kind: type[Any]) -> st.SearchStrategy[Any]:
    """Any record of a class: what it is made of stands in its annotations."""
    return st.builds(
        lambda values: kind(**values),
        st.fixed_dictionaries({name: _of(hint) for name, hint in get_type_hints(kind).items()}),
    )


def _of(hint: Any) -> st.SearchStrategy[Any]:
    """Any value of such a type; of what there may be many, there are few."""
    if get_origin(hint) is not tuple:
        return st.from_type(hint)
    first, *rest = get_args(hint)
    return st.lists(_of(first), max_size=1).map(tuple) if rest == [...] else st.tuples(*map(_of, (first, *rest)))


for _each in CODECS:
    if _each is not Finding:
        st.register_type_strategy(_each, _any_of)


@pytest.mark.parametrize(
    "codecs", [{"sink": records.END}, {"kind": TEXT}, {"kind": TEXT, "name": TEXT, "more": TEXT}], ids=len
)
def test_a_field_that_is_left_out_is_an_error(codecs: dict[str, Codec[Any]]) -> None:
    with pytest.raises(TypeError, match="has the fields"):
        record(End, *codecs.values())
    with pytest.raises(TypeError, match="has the fields"):
        record(NodeSink, **codecs)


def test_each_codec_is_tested() -> None:
    own = {name: value for name, value in vars(records).items() if isinstance(value, Codec) and name not in vars(codec)}
    tested = {id(each) for each in CODECS.values()}
    assert {name for name, value in own.items() if id(value) not in tested and name[0] != "_"} == {
        "FINDINGS",
        "NODES",
        "PLACES",
        "SYSTEMS",
    }


@pytest.mark.parametrize("kind", sample(CODECS, 3), ids=lambda kind: kind.__name__)
def test_what_is_written_is_read_again(kind: type[Any]) -> None:
    form = CODECS[kind]

    @given(st.from_type(kind))
    def law(value: Any) -> None:
        document = text(form.write(value))
        again = form.read(loaded(document))
        assert repr(again) == repr(value)  # also what does not count in a comparison
        assert text(form.write(again)) == document

    law()


@pytest.mark.parametrize("kind", sample(CODECS, 3), ids=lambda kind: kind.__name__)
def test_what_somebody_else_wrote_is_refused_or_has_the_right_types(kind: type[Any]) -> None:
    """One part of a document is replaced by something else: then it is refused, or it was another value of the same type."""
    form = CODECS[kind]

    @given(st.from_type(kind), st.data())
    def law(value: Any, data: st.DataObject) -> None:
        document = loaded(text(form.write(value)))
        changed = _changed(document, data)
        try:
            again = form.read(changed)
        except MalformedError:
            return
        assert type(again) is kind
        assert text(form.write(again)) == text(changed)

    law()


def _changed(document: Any, data: st.DataObject) -> Any:
    if isinstance(document, list) and document and data.draw(st.booleans()):
        index = data.draw(st.integers(0, len(document) - 1))
        return [*document[:index], _changed(document[index], data), *document[index + 1 :]]
    other = st.recursive(
        st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | TEXTS,
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXTS, inner, max_size=2),
        max_leaves=4,
    )
    return data.draw(other)


@given(PLAINS)
def test_plain_values_are_as_they_were(value: object) -> None:
    assert repr(PLAIN.read(loaded(text(PLAIN.write(value))))) == repr(value)


@pytest.mark.parametrize("value", [{}, [{}], [[{"a": 1}]]])
def test_an_object_is_no_plain_value(value: object) -> None:
    with pytest.raises(MalformedError):
        PLAIN.read(value)
    with pytest.raises(MalformedError):
        OPTION.read(value)


@pytest.mark.parametrize("data", [b"", b"{", b"\xff", b"[" * 200_000, b"1" * 5_000, b"[1] 2"])
def test_what_is_no_document_is_malformed(data: bytes) -> None:
    with pytest.raises(MalformedError):
        loaded(data)


def test_two_halves_of_a_character_stay_two() -> None:
    """As JSON is mostly written, they would come back as one character."""
    halves = "\ud83d\ude00"
    assert loaded(text(halves)) == halves
    assert json.loads(json.dumps(halves)) != halves
