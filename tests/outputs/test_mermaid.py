# SPDX-License-Identifier: Apache-2.0
"""The Mermaid drawing: its exact text, and that every line of it is one of a few forms whatever the names are.

a node called `x"]; click a` and a newline  ->  n0(["x#34;#93;#59; click a#92;n…"]), never a line of its own
"""

from __future__ import annotations

import html
import re
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

from rosward.network.connect import connect
from rosward.network.graph import Network
from rosward.outputs.graphs.mermaid import fenced, graph_mermaid
from rosward.ros.entities import EntityKind, Resolution

from .networks import entity, fleet, node, pub, sub, talker_and_listener

EXPECTED = """\
flowchart LR
  s3{{"/add"}}
  t6["/robot_#42;/cmd_vel ?"]
  subgraph g1["/robot1"]
    a0[/"dock"/]
    n1(["listener"])
    n2(["talker"])
    t4["#42; ?"]
    t5["chatter"]
  end
  a0 --> n1
  n1 --> t4
  n2 --> s3
  n2 --> t5
  n2 -.-> t6
  s3 --> n1
  t5 --> n1
  classDef rosNode fill:#d9ecf8,stroke:#0072b2,color:#111
  class n1,n2 rosNode
  classDef rosTopic fill:#fcefd2,stroke:#b07800,color:#111
  class t4,t5,t6 rosTopic
  classDef rosService fill:#d5f0e6,stroke:#00805c,color:#111
  class s3 rosService
  classDef rosAction fill:#f6e2ee,stroke:#a8457e,color:#111
  class a0 rosAction
  classDef rosDoubt stroke:#c44200,stroke-width:2px,stroke-dasharray:5 3
  class t4,t6 rosDoubt
"""

# A label holds letters, digits, a few signs and entities: nothing that Mermaid, Markdown or HTML reads as its own.
LABEL = r'"((?:[A-Za-z0-9_/ .?]|#\d+;)+)"'
SHAPE = re.compile(rf" *(?:(n\d+)\(\[{LABEL}\]\)|(t\d+)\[{LABEL}\]|(s\d+)\{{\{{{LABEL}\}}\}}|(a\d+)\[/{LABEL}/\])")
SUBGRAPH = re.compile(rf" *subgraph (g\d+)\[{LABEL}\]")
ARROW = re.compile(r"  ([ntsa]\d+) (-->|-\.->) ([ntsa]\d+)")
CUT = re.compile(r'  cut\["omitted from this drawing: [a-z0-9 ]+"\]')
STYLE = re.compile(r"  classDef ros[A-Z][a-z]+ [a-z0-9#:,\- ]+|  class [ntsa]\d+(?:,[ntsa]\d+)* ros[A-Z][a-z]+")


class Drawing:
    """A drawing read back; a line that has none of the known forms fails the test."""

    def __init__(self, text: str) -> None:
        first, *lines = text.removesuffix("\n").split("\n")
        assert first == "flowchart LR"
        self.shapes: list[tuple[str, str]] = []
        self.inside: dict[str, tuple[str, ...]] = {}
        self.spaces: list[tuple[str, str]] = []
        self.arrows: list[tuple[str, str, str]] = []
        self.notes: list[str] = []
        around: list[str] = []
        for line in lines:
            if shape := SHAPE.fullmatch(line):
                name, label = (group for group in shape.groups() if group is not None)
                self.shapes.append((name, shown(label)))
                self.inside[name] = tuple(around)
            elif space := SUBGRAPH.fullmatch(line):
                self.spaces.append((space[1], shown(space[2])))
                around.append(shown(space[2]))
            elif line.strip() == "end":
                around.pop()
            elif arrow := ARROW.fullmatch(line):
                self.arrows.append((arrow[1], arrow[2], arrow[3]))
            elif CUT.fullmatch(line):
                self.notes.append(line)
            else:
                assert STYLE.fullmatch(line), line
        assert not around

    def labels(self, look: str) -> list[str]:
        return sorted(label for name, label in self.shapes if name[0] == look)


def shown(label: str) -> str:
    """What a viewer shows for a label."""
    return html.unescape(re.sub(r"#(\d+);", r"&#\1;", label))


def visible(names: list[str]) -> list[str]:
    return sorted(f"{name} ?" if "*" in name else name for name in names)


def test_the_whole_text_of_a_small_network() -> None:
    assert graph_mermaid(talker_and_listener()) == EXPECTED


def test_nothing_to_draw() -> None:
    assert graph_mermaid(connect("jazzy", [])) == "flowchart LR\n"


def test_everything_of_the_network_is_drawn_once() -> None:
    kind = EntityKind
    network = connect(
        "jazzy",
        [
            node("/a", pub("/t"), pub("/u"), entity(kind.SERVICE_SERVER, "/s"), entity(kind.ACTION_CLIENT, "/go")),
            node("/b", sub("/t"), entity(kind.SERVICE_CLIENT, "/s"), entity(kind.ACTION_SERVER, "/go")),
            node("/alone"),
        ],
    )
    drawing = Drawing(graph_mermaid(network))
    assert drawing.labels("n") == ["/a", "/alone", "/b"]
    assert drawing.labels("t") == ["/t", "/u"]
    assert drawing.labels("s") == ["/s"]
    assert drawing.labels("a") == ["/go"]
    assert len(drawing.arrows) == 7


def test_arrows_go_from_publisher_to_subscription_and_from_client_to_server() -> None:
    kind = EntityKind
    ends = [
        (pub("/x"), "/n", "/x"),
        (sub("/x"), "/x", "/n"),
        (entity(kind.SERVICE_CLIENT, "/x"), "/n", "/x"),
        (entity(kind.SERVICE_SERVER, "/x"), "/x", "/n"),
        (entity(kind.ACTION_CLIENT, "/x"), "/n", "/x"),
        (entity(kind.ACTION_SERVER, "/x"), "/x", "/n"),
    ]
    for end, tail, head in ends:
        drawing = Drawing(graph_mermaid(connect("jazzy", [node("/n", end)])))
        names = dict(drawing.shapes)
        assert [(names[a], names[b]) for a, _, b in drawing.arrows] == [(tail, head)]


def test_namespaces_of_nodes_are_nested_subgraphs() -> None:
    network = connect(
        "jazzy", [node("/a/x", pub("/a/x/own"), pub("/far/t")), node("/a/b/y", sub("/a/b/z")), node("/r")]
    )
    drawing = Drawing(graph_mermaid(network))
    assert [label for _, label in drawing.spaces] == ["/a", "/a/b"]
    assert {label: drawing.inside[name] for name, label in drawing.shapes} == {
        "x": ("/a",),
        "x/own": ("/a",),
        "y": ("/a", "/a/b"),
        "z": ("/a", "/a/b"),
        "/far/t": (),
        "/r": (),
    }


def test_an_edge_is_dashed_if_no_execution_is_sure_to_have_it() -> None:
    network = connect(
        "jazzy",
        [
            node("/a", pub("/some", conditional=True)),
            node("/b", pub("/both", conditional=True), pub("/both", "std_msgs/msg/Int8")),
        ],
    )
    drawing = Drawing(graph_mermaid(network))
    names = dict(drawing.shapes)
    assert {names[head]: arrow for _, arrow, head in drawing.arrows} == {"/some": "-.->", "/both": "-->"}


def test_two_unknown_names_never_meet() -> None:
    unknown = Resolution.UNKNOWN
    network = connect("jazzy", [node("/a", pub("/*", resolution=unknown)), node("/b", sub("/*", resolution=unknown))])
    drawing = Drawing(graph_mermaid(network))
    assert drawing.labels("t") == ["/* ?", "/* ?"]
    assert not {head for _, _, head in drawing.arrows} & {tail for tail, _, _ in drawing.arrows if tail[0] == "t"}


def test_system_entities_on_demand() -> None:
    network = connect("jazzy", [node("/a", pub("/t"))])
    assert Drawing(graph_mermaid(network)).labels("t") == ["/t"]
    whole = Drawing(graph_mermaid(network, system=True))
    assert whole.labels("t") == ["/parameter_events", "/rosout", "/t"]
    assert whole.labels("s") == sorted(service.name for service in network.services)


NAMES = st.sampled_from(["/a", "/a/b", "/a/b/c", "/n0", "/t1", "/g1", "/cut", "/end", "/b_*"])


@st.composite
def networks(draw: st.DrawFn) -> Network:
    """Nodes, topics, services and actions out of the same few names."""
    nodes = [
        node(
            fqn,
            *(
                entity(draw(st.sampled_from(EntityKind)), draw(NAMES), conditional=draw(st.booleans()))
                for _ in range(draw(st.integers(0, 5)))
            ),
            system=False,
        )
        for fqn in sorted(draw(st.sets(NAMES, max_size=5)))
    ]
    return connect("jazzy", nodes)


@settings(max_examples=examples(2))
@given(networks())
def test_whatever_has_the_same_name_has_an_identity_of_its_own(network: Network) -> None:
    drawing = Drawing(graph_mermaid(network))
    ids = [name for name, _ in drawing.shapes] + [name for name, _ in drawing.spaces]
    assert max(Counter([*ids, "cut"]).values()) == 1
    assert {end for tail, _, head in drawing.arrows for end in (tail, head)} <= set(ids)
    assert len(set(drawing.arrows)) == len(drawing.arrows)

    def whole(look: str) -> list[str]:
        """The labels with the namespace that a shape stands in put before them again."""
        pairs = [(label, drawing.inside[name]) for name, label in drawing.shapes if name[0] == look]
        return sorted(label if label[0] == "/" else f"{around[-1]}/{label}" for label, around in pairs)

    assert whole("n") == visible([each.fqn for each in network.nodes])
    assert whole("t") == visible([each.name for each in network.topics])
    assert whole("s") == visible([each.name for each in network.services])
    assert whole("a") == visible([each.name for each in network.actions])


HOSTILE = [
    '"',
    "]",
    '"]; click n0 "javascript:alert(1)"',
    "<script>alert(1)</script>",
    "a\nclick n0 call f()",
    "a\r\nend",
    "`**bold**`",
    "```\n# out",
    "end",
    "click x",
    "%%{init: {}}%%",
    "#34;",
    "&quot;",
    ":::rosDoubt",
    "\u2028end",
    "\ud800",
    "\x00",
    "style n0 fill:#f00;",
]


def hostile(name: str) -> Network:
    kind = EntityKind
    return connect(
        "jazzy",
        [
            node(
                "/n",
                pub(f"/{name}"),
                entity(kind.SERVICE_SERVER, f"/{name}"),
                entity(kind.ACTION_CLIENT, f"/{name}"),
                system=False,
                name=name,
                namespace=f"/{name}",
            )
        ],
    )


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_name_stays_in_its_label(name: str) -> None:
    text = graph_mermaid(hostile(name))
    drawing = Drawing(text)
    assert Counter(name[0] for name, _ in drawing.shapes) == Counter("ntsa")
    assert (len(drawing.spaces), len(drawing.arrows)) == (1, 3)
    text.encode("utf-8")


def test_a_name_is_shown_as_it_is_and_a_control_character_as_its_escape() -> None:
    assert Drawing(graph_mermaid(hostile('"]<b>#34;`'))).labels("t") == ['/"]<b>#34;`']
    assert Drawing(graph_mermaid(hostile("a\nb"))).labels("t") == [r"/a\x0ab"]


@settings(max_examples=examples(2))
@given(st.text(st.characters(), max_size=12) | st.sampled_from(HOSTILE))
def test_no_name_breaks_the_drawing_or_the_block(name: str) -> None:
    text = graph_mermaid(hostile(name))
    assert len(Drawing(text).shapes) == 4
    first, *body, last, nothing = fenced(text).split("\n")
    assert (first, last, nothing) == ("```mermaid", "```", "")
    assert "`" not in "".join(body)
    assert "\n".join(body) + "\n" == text


def test_a_very_long_name_is_cut() -> None:
    (label,) = Drawing(graph_mermaid(hostile("x" * 5000))).labels("t")
    assert label == "/" + "x" * 99 + "…"


@pytest.mark.parametrize(
    ("network", "note"),
    [
        (connect("jazzy", [node(f"/n{i:03}", pub("/t")) for i in range(160)]), "10 nodes"),
        (connect("jazzy", [node("/n", *(pub(f"/t{i}") for i in range(405)))]), "5 edges"),
        (
            connect("jazzy", [node(f"/n{i:03}", pub(f"/t{i}"), pub("/t"), pub("/u")) for i in range(151)]),
            "1 nodes and 50 edges",
        ),
    ],
    ids=["nodes", "edges", "both"],
)
def test_what_viewers_would_refuse_is_left_out_and_the_drawing_and_its_block_say_so(
    network: Network, note: str
) -> None:
    text = graph_mermaid(network)
    drawing = Drawing(text)
    assert drawing.notes == [f'  cut["omitted from this drawing: {note}"]']
    assert len(drawing.labels("n")) <= 150
    assert len(drawing.arrows) <= 400
    assert drawing.notes[0] in fenced(text)


def test_long_names_cut_a_drawing_below_the_length_that_viewers_take() -> None:
    crowd = [node(f"/{'*' * 90}{i:03}", pub(f"/{'~' * 90}{i}")) for i in range(150)]
    text = graph_mermaid(connect("jazzy", crowd))
    assert len(text) < 50_000
    drawing = Drawing(text)
    assert drawing.notes
    assert drawing.labels("n")


def test_deep_namespaces_are_no_danger() -> None:
    chain = [node("/a" * depth + "/n", system=False) for depth in range(1, 150)]
    drawing = Drawing(graph_mermaid(connect("jazzy", chain)))
    assert len(drawing.labels("n")) + int(bool(drawing.notes)) >= 2


def test_a_small_network_is_not_cut_and_comes_out_the_same_each_time() -> None:
    text = graph_mermaid(fleet(2))
    assert not Drawing(text).notes
    assert graph_mermaid(fleet(2)) == text
