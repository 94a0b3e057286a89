# SPDX-License-Identifier: Apache-2.0
"""Which texts can be made by an expression alone?"""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair, Way
from .values import condition, number, text


def literal(draft: Draft, block: Block, depth: int) -> Pair:
    word = draft.word()
    return Pair(repr(word), draft.pick([f'std::string("{word}")', f'std::string{{"{word}"}}', f'"{word}"s']))


def local(draft: Draft, block: Block, depth: int) -> Pair:
    return draft.pick(block.texts) if block.texts else literal(draft, block, depth)


def constant(draft: Draft, block: Block, depth: int) -> Pair:
    word, name = draft.word(), draft.fresh("NAME")
    shape = draft.number(0, 3)
    if shape == 0:
        draft.define(f"{name} = {word!r}", f'constexpr const char * {name} = "{word}";')
        return Pair(name, f"std::string({name})")
    if shape == 1:
        draft.define(f"{name} = {word!r}", f'const std::string {name}{{"{word}"}};')
        return Pair(name, name)
    if shape == 2:
        holder = draft.fresh("Names")
        draft.define(
            f"class {holder}:\n    {name} = {word!r}",
            f'struct {holder}\n{{\n  static constexpr const char * {name} = "{word}";\n}};',
        )
        return Pair(f"{holder}.{name}", f"std::string({holder}::{name})")
    macro = f"{name}_OF_{draft.seed}"
    draft.define(f"{macro} = {word!r} '_m'", f'#define {macro} "{word}" "_m"')
    return Pair(macro, f"std::string({macro})")


def concatenation(draft: Draft, block: Block, depth: int) -> Pair:
    one, two = text(draft, block, depth), text(draft, block, depth)
    return Pair(f"({one.py} + '_' + {two.py})", f'({one.cpp} + "_" + {two.cpp})')


def of_number(draft: Draft, block: Block, depth: int) -> Pair:
    value = number(draft, block, depth)
    return Pair(f"('n' + str({value.py}))", f'("n" + std::to_string({value.cpp}))')


def ternary(draft: Draft, block: Block, depth: int) -> Pair:
    test, one, two = condition(draft, block, depth), text(draft, block, depth), text(draft, block, depth)
    return Pair(f"({one.py} if {test.py} else {two.py})", f"({test.cpp} ? {one.cpp} : {two.cpp})")


def indexed(draft: Draft, block: Block, depth: int) -> Pair:
    name, items = draft.fresh("TABLE"), [draft.word() for _ in range(3)]
    listed = ", ".join(f'"{i}"' for i in items)
    kind = draft.pick(
        ["const std::vector<std::string>", "const std::array<const char *, 3>", "static const char * const"]
    )
    draft.define(f"{name} = {items!r}", f"{kind} {name}{'[]' if kind.endswith('* const') else ''} = {{{listed}}};")
    at = draft.number(0, 2)
    return Pair(f"{name}[{at}]", f"std::string({name}[{at}])")


def mapped(draft: Draft, block: Block, depth: int) -> Pair:
    name, keys = draft.fresh("TABLE"), draft.random.sample(["a", "b", "c", "d"], 2)
    values = [draft.word() for _ in keys]
    kind = draft.pick(["std::map", "std::unordered_map"])
    items = ", ".join(f'{{"{k}", "{v}"}}' for k, v in zip(keys, values, strict=True))
    draft.define(
        f"{name} = {dict(zip(keys, values, strict=True))!r}",
        f"const {kind}<std::string, std::string> {name} = {{{items}}};",
    )
    if draft.chance(30):
        return Pair(f"{name}[{keys[0]!r}]", f'{name}.find("{keys[0]}")->second')
    return Pair(f"{name}[{keys[0]!r}]", f'{name}.at("{keys[0]}")')


def function(draft: Draft, block: Block, depth: int) -> Pair:
    name, default = draft.fresh("tag"), draft.word()
    given = text(draft, block, depth)
    how = draft.pick(["const std::string &", "std::string", "std::string_view"])
    value = "std::string(x)" if how == "std::string_view" else "x"
    draft.define(
        f"def {name}(x, y={default!r}, n=1):\n    return x + '_' + y + str(n)",
        f'std::string {name}({how} x, const std::string & y = "{default}", int n = 1)\n{{\n  return {value} + "_" + y + std::to_string(n);\n}}',
    )
    further = draft.number(0, 2)
    more = [text(draft, block, depth + 1), number(draft, block, depth + 1)][:further]
    arguments = [given, *more]
    return Pair(f"{name}({', '.join(a.py for a in arguments)})", f"{name}({', '.join(a.cpp for a in arguments)})")


def overloaded(draft: Draft, block: Block, depth: int) -> Pair:
    name = draft.fresh("show")
    draft.define(
        f"def {name}(x, more=None):\n    if more is not None:\n        return x + '_' + more\n"
        "    return 'i' + str(x) if isinstance(x, int) else 's' + x",
        f'std::string {name}(int x) {{ return "i" + std::to_string(x); }}\n'
        f'std::string {name}(const std::string & x) {{ return "s" + x; }}\n'
        f'std::string {name}(const std::string & x, const std::string & more) {{ return x + "_" + more; }}',
    )
    shape = draft.number(0, 2)
    if shape == 0:
        value = number(draft, block, depth)
        return Pair(f"{name}({value.py})", f"{name}({value.cpp})")
    one, two = text(draft, block, depth), text(draft, block, depth)
    if shape == 1:
        return Pair(f"{name}({one.py})", f"{name}({one.cpp})")
    return Pair(f"{name}({one.py}, {two.py})", f"{name}({one.cpp}, {two.cpp})")


def recursion(draft: Draft, block: Block, depth: int) -> Pair:
    name, mark = draft.fresh("again"), draft.pick("xyz")
    draft.define(
        f"def {name}(n):\n    if n <= 0:\n        return 'end'\n    return {mark!r} + {name}(n - 1)",
        f'std::string {name}(int n)\n{{\n  if (n <= 0) {{\n    return "end";\n  }}\n  return "{mark}" + {name}(n - 1);\n}}',
    )
    count = draft.number(0, 3)
    return Pair(f"{name}({count})", f"{name}({count})")


def switched(draft: Draft, block: Block, depth: int) -> Pair:
    name, kind = draft.fresh("side_of"), draft.fresh("Side")
    labels = [draft.word() for _ in range(3)]
    cases = "".join(f'\n    case {kind}::v{i}: return "{label}";' for i, label in enumerate(labels[:2]))
    draft.define(
        f"class {kind}(Enum):\n    v0 = 0\n    v1 = 1\n    v2 = 2\n\n\n"
        f"def {name}(side):\n    if side == {kind}.v0:\n        return {labels[0]!r}\n    elif side == {kind}.v1:\n"
        f"        return {labels[1]!r}\n    return {labels[2]!r}",
        f"enum class {kind} {{ v0, v1, v2 }};\n\nstd::string {name}({kind} side)\n{{\n  switch (side) {{{cases}\n"
        f'    default: return "{labels[2]}";\n  }}\n}}',
    )
    which = draft.number(0, 2)
    return Pair(f"{name}({kind}.v{which})", f"{name}({kind}::v{which})")


def called_lambda(draft: Draft, block: Block, depth: int) -> Pair:
    given, mark = text(draft, block, depth), draft.word()
    return Pair(
        f"(lambda x: x + '_{mark}')({given.py})", f'[](const std::string & x) {{ return x + "_{mark}"; }}({given.cpp})'
    )


def optional(draft: Draft, block: Block, depth: int) -> Pair:
    name, word = draft.fresh("maybe"), draft.word()
    other = text(draft, block, depth)
    draft.define(
        f"def {name}(wanted):\n    return {word!r} if wanted else None",
        f'std::optional<std::string> {name}(bool wanted)\n{{\n  if (!wanted) {{\n    return std::nullopt;\n  }}\n  return "{word}";\n}}',
    )
    wanted = draft.chance(50)
    return Pair(f"({name}({wanted}) or {other.py})", f"{name}({str(wanted).lower()}).value_or({other.cpp})")


def duck(draft: Draft, block: Block, depth: int) -> Pair:
    name, one, two = draft.fresh("label_of"), draft.fresh("Tool"), draft.fresh("Tool")
    for tool in (one, two):
        word = draft.word()
        draft.define(
            f"class {tool}:\n    def name(self, n):\n        return {word!r} + str(n)",
            f'struct {tool}\n{{\n  std::string name(int n) const {{ return "{word}" + std::to_string(n); }}\n}};',
        )
    draft.define(
        f"def {name}(tool, n):\n    return tool.name(n) + '_tool'",
        f'template<typename T>\nstd::string {name}(const T & tool, int n)\n{{\n  return tool.name(n) + "_tool";\n}}',
    )
    value, tool = number(draft, block, depth), draft.pick([one, two])
    return Pair(f"{name}({tool}(), {value.py})", f"{name}({tool}(), {value.cpp})")


def of_type(draft: Draft, block: Block, depth: int) -> Pair:
    name, holder, word = draft.fresh("joined"), draft.fresh("Traits"), draft.word()
    draft.define(
        f"class {holder}:\n    label = {word!r}\n\n\ndef {name}(kind, *parts):\n    return kind.label + ''.join('_' + p for p in parts)",
        f'struct {holder}\n{{\n  static constexpr const char * label = "{word}";\n}};\n\n'
        f"template<typename T, typename ... Parts>\nstd::string {name}(const Parts & ... parts)\n{{\n"
        '  return std::string(T::label) + (std::string() + ... + ("_" + parts));\n}',
    )
    parts = [text(draft, block, depth + 1) for _ in range(draft.number(1, 2))]
    return Pair(
        f"{name}({holder}, {', '.join(p.py for p in parts)})", f"{name}<{holder}>({', '.join(p.cpp for p in parts)})"
    )


LEAVES: Final[tuple[Way, ...]] = (literal, local, local, constant, indexed, mapped)
PURE: Final[tuple[Way, ...]] = (
    *(
        concatenation,
        of_number,
        ternary,
        function,
        overloaded,
        recursion,
        switched,
        called_lambda,
        optional,
        duck,
        of_type,
    )
    * 2,
)
