# SPDX-License-Identifier: Apache-2.0
"""Which values a node is given: types, lists, names, files, and what nav2 rewrites in them."""

from __future__ import annotations

import pytest

from deployment.execution import HERE, UNKNOWN, Run, plain, share, text, var
from rosward.deployment import tree
from rosward.domain.compound import Tuple
from rosward.domain.values import Const, Value
from rosward.ros.distro import Distro

TRUE = Const(True)


def setting(data: tree.ParameterData, v: str = "") -> tuple[str, list[str]]:
    """The value of one parameter, as launch evaluates it, and the codes of findings."""
    table = tree.ParameterTable(((text("x"), data),), HERE)
    declare = tree.Declare(place=HERE, name=text("v"))
    run = Run([declare, tree.StartNode(place=HERE, executable=text("e"), parameters=(table,))], v=v)
    return plain(run.started[0].settings[0].value), run.codes


@pytest.mark.parametrize(
    ("value", "found"),
    [
        ("true", "True"),
        ("yes", "True"),
        ("1", "1"),
        ("1.5", "1.5"),
        ("[1, 2]", "[1, 2]"),
        ("['a', b]", "['a', 'b']"),
        ("'1'", "'1'"),
        ("abc", "'abc'"),
        ("", "''"),
        ("1:30", "90"),
    ],
)
def test_text_is_read_as_yaml(value: str, found: str) -> None:
    assert setting(tree.Typed(var("v")), v=value) == (found, [])


@pytest.mark.parametrize("value", ["{a: 1}", "[]", "[1, a]", "null", "[[1]]", "a: b: c", "[" * 2000])
def test_text_that_is_no_parameter(value: str) -> None:
    found, codes = setting(tree.Typed(var("v")), v=value)
    assert (found, codes) == ("?", ["RW320"])


@pytest.mark.parametrize(
    ("value", "kind", "found"),
    [
        ("true", "str", "'true'"),
        ("1", "float", "1.0"),
        ("1", "bool", "True"),
        ("yes", "bool", "True"),
        ("[1, 2]", "List[int]", "[1, 2]"),
        ("[]", "List[…]", "[]"),
        ("[a]", "List[…]", "['a']"),
        ("[1, 2]", "yaml", "[1, 2]"),
    ],
)
def test_a_type_that_is_forced(value: str, kind: str, found: str) -> None:
    assert setting(tree.Typed(var("v"), kind), v=value) == (found, [])


@pytest.mark.parametrize(
    ("value", "kind"), [("x", "int"), ("1.5", "int"), ("2", "bool"), ("1", "List[int]"), ("a", "List[…]")]
)
def test_a_type_that_does_not_fit(value: str, kind: str) -> None:
    assert setting(tree.Typed(var("v"), kind), v=value) == ("?", ["RW320"])


@pytest.mark.parametrize(
    ("data", "found"),
    [
        (tree.Literal(Const("true")), "'true'"),  # a plain str stays one
        (tree.Literal(Tuple((Const(1), Const(2.5)))), "[1.0, 2.5]"),
        (tree.Typed((*var("v"), Const("5"))), "15"),  # [LaunchConfiguration('v'), '5'] is one text
        (tree.Several((tree.Typed(var("v")), tree.Typed(text("2")))), "[1, 2]"),
    ],
)
def test_literals_and_lists(data: tree.ParameterData, found: str) -> None:
    assert setting(data, v="1") == (found, [])


@pytest.mark.parametrize(
    ("value", "found"),
    [(share("demo", "/a.yaml"), "'*/a.yaml'"), (UNKNOWN, "?"), (Const("x"), "'x'")],
)
def test_text_that_is_partly_known(value: Value, found: str) -> None:
    assert setting(tree.Typed((value,))) == (found, [])


def test_a_number_in_scientific_notation_changes_its_type_on_the_way() -> None:
    """PyYAML takes 1e3 for a str and writes it without quotes; rcl reads a double."""
    assert Run('<node pkg="p" exec="e"><param name="x" value="1e3" type="str"/></node>').lines == [
        "p/e --ros-args --params-file {/** x=1000.0}"
    ]


def test_nested_names_are_dotted() -> None:
    main = '<node pkg="p" exec="e"><param name="sub"><param name="x" value="1"/></param></node>'
    assert Run(main).lines == ["p/e --ros-args --params-file {/** sub.x=1}"]


def test_a_global_parameter_is_printed_as_python_does() -> None:
    main = '<set_parameter name="a" value="true"/><set_parameter name="b" value="[1, 2]"/><node pkg="p" exec="e"/>'
    assert Run(main).lines == ["p/e --ros-args -p a:=True -p b:=(1, 2)"]


def test_a_parameter_description_is_written_as_yaml() -> None:
    rule = tree.ParameterArgument(text("x"), tree.Typed(text("5")), HERE)
    run = Run([tree.StartNode(place=HERE, executable=text("e"), parameters=(rule,))])
    assert [w.value for w in run.started[0].configuration.words[1:] if isinstance(w, Const)] == ["-p", "x:=5\n...\n"]


def test_a_substitution_of_a_global_parameter() -> None:
    main = '<set_parameter name="rate" value="5"/><node pkg="p" exec="$(param rate)"/><node pkg="p" exec="$(param other)"/>'
    run = Run(main)
    assert run.lines == ["p/5 --ros-args -p rate:=5", "p/* --ros-args -p rate:=5"]
    assert run.codes == ["RW320"]


# Files

FILE = "/**: {ros__parameters: {a: 1}}\nleft/arm: {ros__parameters: {b: $(var x)}}\n"


def test_a_file_of_a_package_that_is_not_there_may_say_anything() -> None:
    run = Run('<node pkg="p" exec="e"><param from="$(find-pkg-share acme)/a.yaml"/></node>')
    (configuration,) = [s.configuration for s in run.started]
    assert run.lines == ["p/e --ros-args --params-file */a.yaml"]
    assert configuration.files == {"*/a.yaml": None}
    assert str(configuration.missing["*/a.yaml"]).startswith("content of a file: $(find-pkg-share acme)/a.yaml")


def test_a_file_with_substitutions_is_performed() -> None:
    main = """<arg name="x" default="7"/>
        <node pkg="p" exec="e"><param from="$(find-pkg-share demo)/a.yaml" allow_substs="true"/></node>"""
    assert Run(main, {"demo/a.yaml": FILE}).lines == ["p/e --ros-args --params-file {/** a=1, left/arm b=7}"]


def test_a_file_with_an_unknown_substitution() -> None:
    main = """<let name="x" value="$(env X)"/>
        <node pkg="p" exec="e"><param from="$(find-pkg-share demo)/a.yaml" allow_substs="true"/></node>"""
    assert Run(main, {"demo/a.yaml": FILE}).lines == ["p/e --ros-args --params-file {/** a=1, left/arm b=?}"]


def rewritten(pairs: dict[str, tree.Template], root: tree.Template = (), convert: str = "True") -> tree.Substitution:
    table = tuple((text(k), v) for k, v in pairs.items())
    path = (share("demo", "/nav.yaml"),)
    return tree.Substitution("rewritten-yaml", (path, root, text(convert)), HERE, None, (table, ()))


NAV = """
amcl:
  ros__parameters:
    use_sim_time: true
    base_frame: base_link
    scan: {topic: scan, rate: 5}
map:
  ros__parameters:
    use_sim_time: true
"""


def content(substitution: tree.Substitution, ns: str = "left") -> str:
    file = tree.ParameterFile((substitution,), HERE)
    start = tree.StartNode(place=HERE, executable=text("e"), parameters=(file,))
    declare = tree.Declare(place=HERE, name=text("ns"))
    return Run([declare, start], {"demo/nav.yaml": NAV}, ns=ns).lines[0].partition("{")[2]


def test_rewritten_values_replace_every_key_of_that_name() -> None:
    found = content(
        rewritten({"use_sim_time": text("false"), "base_frame": (*var("ns"), Const("/base")), "rate": text("7")})
    )
    assert (
        found
        == "amcl use_sim_time=False, amcl base_frame='left/base', amcl scan.topic='scan', amcl scan.rate=7, map use_sim_time=False}"
    )


def test_without_convert_types_numbers_stay_text() -> None:
    assert "scan.rate='7'" in content(rewritten({"rate": text("7")}, convert="False"))


def test_rewritten_paths_and_new_parameters() -> None:
    found = content(
        rewritten({"amcl.ros__parameters.use_sim_time": text("false"), "map.ros__parameters.new": text("x")})
    )
    assert found.startswith("amcl use_sim_time=False")
    assert found.endswith("map use_sim_time=True, map new='x'}")


def test_a_root_key_is_a_namespace() -> None:
    assert content(rewritten({}, var("ns"))).startswith("left/amcl use_sim_time=True")


def test_an_unknown_value_in_a_rewrite() -> None:
    found = content(rewritten({"base_frame": var("ns")}), ns="*")
    assert "amcl base_frame=?" in found


def test_a_rewritten_file_goes_through_an_include() -> None:
    inner = '<launch><arg name="params"/><node pkg="p" exec="e"><param from="$(var params)"/></node></launch>'
    include = tree.Include(
        place=HERE,
        path=(share("demo", "/launch/inner.launch.xml"),),
        arguments=((text("params"), (rewritten({"rate": text("9")}),)),),
    )
    run = Run([include], {"demo/nav.yaml": NAV, "demo/launch/inner.launch.xml": inner})
    assert "amcl scan.rate=9" in run.lines[0]


def test_text_that_is_replaced_in_a_file() -> None:
    source = (share("demo", "/nav.yaml"),)
    pairs = (((text("<ns>")), var("ns")),)
    replace = tree.Substitution("replace-string", (source,), HERE, None, (pairs,))
    file = tree.ParameterFile((replace,), HERE)
    declare = tree.Declare(place=HERE, name=text("ns"), default=text("left"))
    start = tree.StartNode(place=HERE, executable=text("e"), parameters=(file,))
    texts = {"demo/nav.yaml": "/<ns>/amcl: {ros__parameters: {topic: <ns>/scan, n: 1}}"}
    assert Run([declare, start], texts).lines == [
        "e --ros-args --params-file {/left/amcl topic='left/scan', /left/amcl n=1}"
    ]
    assert Run([declare, start], texts, ns="*").lines == [
        "e --ros-args --params-file {/*/amcl topic='*/scan', /*/amcl n=1}"
    ]


def test_a_file_with_a_path_that_has_alternatives() -> None:
    texts = {f"demo/{n}.yaml": f"/**: {{ros__parameters: {{k: {n}}}}}" for n in "ab"}
    main = """<arg name="k"><choice value="a"/><choice value="b"/></arg>
        <node pkg="p" exec="e"><param from="$(find-pkg-share demo)/$(var k).yaml"/></node>"""
    run = Run(main, texts, k="*")
    assert run.lines == ["p/e --ros-args --params-file */a.yaml|*/b.yaml"]
    assert sorted(run.started[0].configuration.files) == ["*/a.yaml", "*/b.yaml"]


# Components

CONTAINER = '<node_container pkg="c" exec="c" name="cont" namespace="top">{}</node_container>'


def test_a_component_gets_what_is_for_it_or_for_all() -> None:
    texts = {
        "demo/a.yaml": "/**: {ros__parameters: {a: 1}}\n/top/cam: {ros__parameters: {b: 2}}\n/*/cam: {ros__parameters: {c: 3}}\n"
    }
    one = """<composable_node pkg="p" plugin="P" name="cam" namespace="top">
        <param from="$(find-pkg-share demo)/a.yaml"/><param name="a" value="5"/></composable_node>"""
    assert Run(CONTAINER.format(one), texts).lines[1].partition("{")[2] == "/** b=2, /** a=5}"


def test_a_component_with_a_file_that_is_not_known() -> None:
    one = (
        '<composable_node pkg="p" plugin="P" name="cam"><param from="$(find-pkg-share acme)/a.yaml"/></composable_node>'
    )
    assert Run(CONTAINER.format(one)).lines[1].partition("{")[2] == "/** *=?}"


def test_humble_ignores_the_condition_of_a_component_that_is_loaded_later() -> None:
    never = tree.Condition("if", (text("false"),), HERE)
    component = tree.Component(package=text("p"), plugin=text("P"), place=HERE, condition=never)
    load = tree.LoadComponents(place=HERE, target=text("/c"), components=(component,))
    assert Run([load]).lines == []
    assert Run([load], distro=Distro.HUMBLE).lines == ["p/P in /c --ros-args"]
