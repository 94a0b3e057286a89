# SPDX-License-Identifier: Apache-2.0
"""Which values come from parameters of the node, with a default?"""

from __future__ import annotations

from .draft import Block, Draft, Pair
from .numbers import compared, small
from .texts import literal
from .values import DEPTH


def text_parameter(draft: Draft, block: Block, depth: int) -> Pair:
    return _parameter(
        draft, block, block.texts, Pair(repr(word := draft.word()), f'"{word}"'), "std::string", "as_string"
    )


def int_parameter(draft: Draft, block: Block, depth: int) -> Pair:
    value = str(draft.number(0, 4))
    return _parameter(draft, block, block.numbers, Pair(value, value), "int", "as_int")


def bool_parameter(draft: Draft, block: Block, depth: int) -> Pair:
    value = draft.chance(50)
    return _parameter(draft, block, None, Pair(str(value), str(value).lower()), "bool", "as_bool")


def _parameter(draft: Draft, block: Block, kind: list[Pair] | None, default: Pair, type_: str, getter: str) -> Pair:
    if draft.known or not block.node.py:
        return {"std::string": literal, "int": small, "bool": compared}[type_](draft, block, DEPTH)
    draft.open = True
    name, variable = draft.fresh("param"), draft.fresh("v")
    py, cpp = block.node.py, block.node.call
    block.say(
        f"{py}.declare_parameter('{name}', {default.py})\n{variable} = {py}.get_parameter('{name}').value",
        draft.pick(
            [
                f'const {type_} {variable} = {cpp}declare_parameter("{name}", {default.cpp});',
                f'const {type_} {variable} = {cpp}template declare_parameter<{type_}>("{name}", {default.cpp});'
                if cpp.startswith("this")
                else f'const {type_} {variable} = {cpp}declare_parameter<{type_}>("{name}", {default.cpp});',
                f'{cpp}declare_parameter("{name}", {default.cpp});\n'
                f'const {type_} {variable} = {cpp}get_parameter("{name}").{getter}();',
                f'{cpp}declare_parameter("{name}", {default.cpp});\n'
                f'{type_} {variable};\n{cpp}get_parameter("{name}", {variable});',
            ]
        ),
    )
    if kind is not None:
        return block.remember(kind, variable)
    return Pair(variable, variable)
