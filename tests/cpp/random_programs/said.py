# SPDX-License-Identifier: Apache-2.0
"""Which texts need statements before the expression?"""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair, Way
from .values import number, text, words


def counted(draft: Draft, block: Block, depth: int) -> Pair:
    """Each call gives the next number: order of evaluation counts."""
    name = draft.fresh("count")
    draft.define(
        f"{name}_next = 0\n\n\ndef {name}():\n    global {name}_next\n    {name}_next += 1\n    return {name}_next",
        f"int {name}()\n{{\n  static int next = 0;\n  return ++next;\n}}",
    )
    variable = draft.fresh("v")
    block.say(
        f"{variable} = 'c' + str({name}()) + str({name}())", f'std::string {variable} = "c" + std::to_string({name}());'
    )
    block.say("", f"{variable} += std::to_string({name}());")
    return block.remember(block.texts, variable)


def sliced(draft: Draft, block: Block, depth: int) -> Pair:
    variable, given, at = draft.fresh("v"), text(draft, block, depth), draft.number(1, 2)
    block.say(f"{variable} = {given.py}", f"const std::string {variable} = {given.cpp};")
    block.remember(block.texts, variable)
    return draft.pick(
        [
            Pair(f"{variable}[:{at}]", f"{variable}.substr(0, {at})"),
            Pair(f"{variable}[{at}:]", f"{variable}.substr({at})"),
            Pair(f"{variable}[0]", f"std::string(1, {variable}.front())"),
            Pair(f"{variable}[-1]", f"std::string(1, {variable}.back())"),
            Pair(f"{variable}.partition('_')[0]", f"{variable}.substr(0, {variable}.find('_'))"),
        ]
    )


def formatted(draft: Draft, block: Block, depth: int) -> Pair:
    variable, given, value = draft.fresh("buffer"), text(draft, block, depth), number(draft, block, depth)
    block.say(
        f"{variable} = '%s_%02d' % ({given.py}, {value.py})",
        f'char {variable}[400];\nstd::snprintf({variable}, sizeof({variable}), "%s_%02d", ({given.cpp}).c_str(), {value.cpp});',
    )
    return Pair(variable, f"std::string({variable})")


def streamed(draft: Draft, block: Block, depth: int) -> Pair:
    variable, given, value = draft.fresh("stream"), text(draft, block, depth), number(draft, block, depth)
    block.say(
        f"{variable} = f'{{{given.py}}}_{{{value.py}}}'"
        if "'" not in given.py + value.py
        else f"{variable} = {given.py} + '_' + str({value.py})",
        "",
    )
    block.say("", f'std::ostringstream {variable};\n{variable} << {given.cpp} << "_" << {value.cpp};')
    return Pair(variable, f"{variable}.str()")


def changed(draft: Draft, block: Block, depth: int) -> Pair:
    variable, given = draft.fresh("v"), text(draft, block, depth)
    block.say(f"{variable} = {given.py}", f"std::string {variable} = {given.cpp};")
    py, cpp = draft.pick(
        [
            (
                f"{variable} = {variable}.upper()",
                f"std::transform({variable}.begin(), {variable}.end(), {variable}.begin(), ::toupper);",
            ),
            (
                f"{variable} = {variable}.replace('e', '3')",
                f"std::replace({variable}.begin(), {variable}.end(), 'e', '3');",
            ),
            (f"{variable} += '_more'", f'{variable} += "_more";'),
            (f"{variable} = {variable} + 'x'", f"{variable}.push_back('x');"),
            (f"{variable} = 'pre' + {variable}", f'{variable}.insert(0, "pre");'),
            (f"{variable} = {variable}[:-1] + 'z'", f"{variable}.back() = 'z';"),
            (f"{variable} = {variable} + 'end'", f'{variable} = {variable}.append("end");'),
        ]
    )
    block.say(py, cpp)
    return block.remember(block.texts, variable)


def joined(draft: Draft, block: Block, depth: int) -> Pair:
    variable, items = draft.fresh("v"), words(draft, block)
    block.say(
        f"{variable} = ''\nfor part in {items.py}:\n    {variable} += part[0] + '_'\n{variable} += 'e'",
        f"std::string {variable};\nfor (const auto & part : {items.cpp}) {{\n  {variable} += part[0];\n  {variable} += '_';\n}}\n{variable} += 'e';",
    )
    return block.remember(block.texts, variable)


def unpacked(draft: Draft, block: Block, depth: int) -> Pair:
    name, one, two, given = draft.fresh("ends"), draft.fresh("v"), draft.fresh("v"), text(draft, block, depth)
    draft.define(
        f"def {name}(x):\n    return x, 'to_' + x",
        f'std::pair<std::string, std::string> {name}(const std::string & x)\n{{\n  return {{x, "to_" + x}};\n}}',
    )
    block.say(
        f"{one}, {two} = {name}({given.py})",
        f"const auto {two}_pair = {name}({given.cpp});\nconst auto [{one}, {two}_raw] = {two}_pair;",
    )
    block.say("", f"const std::string {two} = {two}_raw;")
    return block.remember(block.texts, two)


SAID: Final[tuple[Way, ...]] = (counted, sliced, formatted, streamed, changed, joined, unpacked)
