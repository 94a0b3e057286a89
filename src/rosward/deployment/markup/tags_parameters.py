# SPDX-License-Identifier: Apache-2.0
"""Which parameters do the <param> tags of a node give?

    <param name="pid"><param name="p" value="0.5"/></param>   ->  ParameterTable((((Const('pid'), Const('.'), Const('p')), Literal(Const(0.5))),))
    <param name="id" value="$(var id)" type="str"/>           ->  ParameterTable((((Const('id'),), Typed((Substitution('var', …),), 'str')),))
    <param from="$(find-pkg-share demo)/p.yaml"/>             ->  ParameterFile(…)

An XML value is read as YAML first, whether it has substitutions or not; what they give is read as YAML again, unless a type says otherwise.
A text without substitutions stays a text: '"1"' is a string.
"""

from __future__ import annotations

from typing import Final

from rosward.deployment.markup.element import Attribute, Format, Tag
from rosward.deployment.markup.substitutions import plain_text, unknown_text
from rosward.deployment.markup.values import Native, Scalar, text_value
from rosward.deployment.tree import (
    Literal,
    ParameterData,
    ParameterFile,
    ParameterSource,
    ParameterTable,
    Several,
    Template,
    Typed,
)
from rosward.domain.compound import Tuple
from rosward.domain.values import Const

_SCALARS: Final[dict[str, type[Scalar]]] = {"str": str, "bool": bool, "int": int, "float": float}
_LIST: Final = "list_of_"

_Entries = list[tuple[Template, ParameterData]]


def read_parameters(element: Tag) -> tuple[ParameterSource, ...]:
    """All that <param> gives, in order."""
    found: list[ParameterSource] = []
    for param in element.elements("param"):
        path, substitutions = param.template("from"), param.flag("allow_substs")
        name = param.template("name")
        if path is not None:
            if name is not None:
                param.refuse("<param> has both 'name' and 'from', which launch does not accept together.")
            if isinstance(substitutions, str):
                param.parsed(substitutions)
            found.append(ParameterFile(path, param.place, bool(substitutions)))
            param.finish()
        elif name is not None:
            if substitutions is not None:
                param.refuse("'allow_substs' of <param> is allowed only with 'from'.")
            entries: _Entries = []
            _read(param, name, entries)
            found.append(ParameterTable(tuple(entries), param.place))
        else:
            param.refuse("<param> has neither 'name' nor 'from'.")
    return tuple(found)


def _read(param: Tag, name: Template, entries: _Entries) -> None:
    kind = param.text("type")
    value = param.attribute("value")
    nested = param.elements("param")
    if value is not None:
        entries.append((name, _data(param, value, _kind(param, kind))))
    elif not nested:
        param.refuse("<param> has neither a 'value' nor nested parameters.")
    if nested and (value is not None or kind is not None):
        param.refuse("<param> has nested parameters; launch accepts neither 'value' nor 'type' with them.")
    for each in nested:
        _read(each, (*name, Const("."), *each.required("name")), entries)
    param.finish()


def _kind(param: Tag, kind: str | None) -> str | None:
    """The type that is asked for, as `List[…]` if it is a list; None for YAML's own."""
    if kind is None or kind == "yaml":
        return None
    scalar = kind.removeprefix(_LIST)
    if scalar not in _SCALARS:
        param.refuse(f"launch has no parameter type {kind!r}.")
        return None
    return f"List[{scalar}]" if kind.startswith(_LIST) else kind


def _data(param: Tag, attribute: Attribute, kind: str | None) -> ParameterData:
    value = attribute.value if param.format is Format.YAML else _from_xml(param, attribute.text, kind)
    if value is None:
        param.refuse("The value of <param> is not a valid parameter value.", attribute.place)
        return Typed(param.parsed(attribute.text) if attribute.text else unknown_text("value", param.place), kind)
    is_list = kind is not None and kind.startswith("List[")
    inner = kind[5:-1] if kind is not None and is_list else kind
    if not isinstance(value, tuple):
        data = _scalar(param, value, inner)
        if is_list:
            param.refuse(f"The value of <param> is not a list, which {kind} requires.", attribute.place)
        return Typed(data.text, kind) if is_list and isinstance(data, Typed) else data
    if kind is not None and not is_list:
        param.refuse(f"The value of <param> is a list, not a {kind}.", attribute.place)
        inner = None
    items = [_scalar(param, each, inner) for each in value]
    literals = [each.value for each in items if isinstance(each, Literal)]
    types = {type(each.value) for each in literals if isinstance(each, Const)}
    if len(types) > 1:
        param.refuse("The list in <param> has elements of several types.", attribute.place)
    elif inner is not None and not types <= {_SCALARS[inner]}:
        param.refuse(f"The list in <param> is not of type {kind}.", attribute.place)
    elif not items and inner not in {None, "str"}:
        param.refuse(f"The list in <param> is empty, which launch does not accept as {kind}.", attribute.place)
    return Literal(Tuple(tuple(literals))) if len(literals) == len(items) else Several(tuple(items))


def _scalar(param: Tag, value: Scalar, kind: str | None) -> Literal | Typed:
    """One value; text may hold substitutions."""
    wanted = _SCALARS.get(kind or "")
    if not isinstance(value, str):
        if wanted is not None and not isinstance(value, wanted):
            param.refuse(f"{value!r} in <param> is not of type {kind}.")
        return Literal(Const(value))
    template = param.parsed(value)
    text = plain_text(template)
    if text is None:
        return Typed(template, kind or "yaml")
    if wanted not in {None, str}:
        param.refuse(f"{value!r} in <param> is not of type {kind}.")
    return Literal(Const(text))


def _from_xml(param: Tag, text: str, kind: str | None) -> Native:
    """What launch_xml converts the text to; it stays text where that fails, since it may hold substitutions."""
    separator = param.text("value-sep")
    if separator is not None:
        inner = kind.removeprefix("List[").removesuffix("]") if kind else None
        if not separator:
            param.refuse("'value-sep' of <param> is empty.")
            return None
        items = [_converted(each, inner) for each in text.split(separator)]
        scalars = tuple(each for each in items if each is not None and not isinstance(each, tuple))
        return scalars if len(scalars) == len(items) else None
    return _converted(text, kind)


def _converted(text: str, kind: str | None) -> Native:
    if kind == "str":
        return text
    if kind in {"int", "float"}:
        if len(text) > 4_000:
            return text
        try:
            return int(text) if kind == "int" else float(text)
        except ValueError:
            return text
    if kind == "bool" and text in {"0", "1"}:
        return text == "1"
    return text_value(text)
