# SPDX-License-Identifier: Apache-2.0
"""Where does control go in a body? Branches, loops, exceptions."""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair, Statement
from .statements import DEPTH, statements
from .values import condition, number, text, words


def branch(draft: Draft, block: Block, depth: int) -> None:
    test = condition(draft, block)
    yes, no = block.nested(), block.nested()
    statements(draft, yes, depth + 1, draft.number(0, 1))
    block.say(f"if {test.py}:\n{yes.py()}", f"if ({test.cpp}) {{\n{yes.cpp()}\n}}")
    if draft.chance(60):
        statements(draft, no, depth + 1, draft.number(0, 1))
        block.say(f"else:\n{no.py()}", f"else {{\n{no.cpp()}\n}}")


def environment(draft: Draft, block: Block, depth: int) -> None:
    """Nobody knows but the run."""
    if draft.known:
        branch(draft, block, depth)
        return
    draft.open = True
    name, inner = draft.fresh("ROBOT_VARIABLE_"), block.nested()
    statements(draft, inner, depth + 1, 0)
    block.say(
        f"if os.environ.get('{name}') is not None:\n{inner.py()}",
        f'if (std::getenv("{name}") != nullptr) {{\n{inner.cpp()}\n}}',
    )


def over_list(draft: Draft, block: Block, depth: int) -> None:
    item, items, inner = draft.fresh("v"), words(draft, block), block.nested()
    inner.remember(inner.texts, item)
    statements(draft, inner, depth + 1, draft.number(0, 1))
    how = draft.pick(["const auto &", "const std::string &", "auto", "std::string", "auto &&"])
    if draft.chance(25):
        word = draft.word()
        block.say(f"for {item} in {items.py}:\n    if {item} == {word!r}:\n        continue\n{inner.py()}", "")
        block.say(
            "",
            f'for ({how} {item} : {items.cpp}) {{\n  if ({item} == "{word}") {{\n    continue;\n  }}\n{inner.cpp()}\n}}',
        )
    else:
        block.say(f"for {item} in {items.py}:\n{inner.py()}", f"for ({how} {item} : {items.cpp}) {{\n{inner.cpp()}\n}}")


def over_numbers(draft: Draft, block: Block, depth: int) -> None:
    item, inner, end = draft.fresh("v"), block.nested(), number(draft, block)
    inner.remember(inner.numbers, item)
    statements(draft, inner, depth + 1, draft.number(0, 1))
    shape = draft.number(0, 2)
    if shape == 0:
        block.say(
            f"for {item} in range(({end.py}) % 4):\n{inner.py()}",
            f"for (int {item} = 0; {item} < ({end.cpp}) % 4; {item}++) {{\n{inner.cpp()}\n}}",
        )
    elif shape == 1:
        block.say(
            f"for {item} in range(5, 0, -2):\n{inner.py()}",
            f"for (int {item} = 5; {item} > 0; {item} -= 2) {{\n{inner.cpp()}\n}}",
        )
    else:
        block.say(
            f"{item} = ({end.py}) % 4\nwhile {item} > 0:\n    {item} -= 1\n    if {item} == 5:\n        break\n{inner.py()}",
            f"int {item} = ({end.cpp}) % 4;\nwhile ({item} > 0) {{\n  {item}--;\n  if ({item} == 5) {{\n    break;\n  }}\n{inner.cpp()}\n}}",
        )


def over_map(draft: Draft, block: Block, depth: int) -> None:
    table, key, value = draft.fresh("v"), draft.fresh("v"), draft.fresh("v")
    items = [(draft.word(), text(draft, block, 2)) for _ in range(2)]
    py = "; ".join(f"{table}[{k!r}] = {v.py}" for k, v in items)
    cpp = " ".join(f'{table}["{k}"] = {v.cpp};' for k, v in items)
    inner = block.nested()
    inner.texts += [
        Pair(key, key),
        Pair(value, value),
    ]  # a structured binding cannot be captured: it is no local variable here
    own = Block(inner.node, inner.keep)
    own.texts, own.numbers, own.lists = inner.texts, inner.numbers, inner.lists
    statements(draft, own, DEPTH, 0)
    block.say(
        f"{table} = {{}}\n{py}\nfor {key}, {value} in sorted({table}.items()):\n{own.py()}",
        f"std::map<std::string, std::string> {table};\n{cpp}\nfor (const auto & [{key}, {value}] : {table}) {{\n{own.cpp()}\n}}",
    )


def over_table(draft: Draft, block: Block, depth: int) -> None:
    """A table of records."""
    kind, table, row, inner = draft.fresh("Row"), draft.fresh("ROWS"), draft.fresh("v"), block.nested()
    rows = [(draft.word(), draft.number(0, 3), draft.chance(70)) for _ in range(3)]
    draft.define(
        f"class {kind}(NamedTuple):\n    name: str\n    count: int\n    used: bool = True\n\n\n{table} = {[*rows]!r}\n"
        f"{table} = [{kind}(*row) for row in {table}]",
        f"struct {kind}\n{{\n  std::string name;\n  int count;\n  bool used;\n}};\n\nconst std::vector<{kind}> {table} = {{\n"
        + "\n".join(f'  {{"{name}", {count}, {str(used).lower()}}},' for name, count, used in rows)
        + "\n};",
    )
    inner.texts.append(Pair(f"{row}.name", f"{row}.name"))
    inner.numbers.append(Pair(f"{row}.count", f"{row}.count"))
    own = inner.nested(captured=[])
    own.texts, own.numbers = inner.texts, inner.numbers
    statements(draft, own, DEPTH, 0)
    block.say(
        f"for {row} in {table}:\n    if not {row}.used:\n        continue\n{own.py()}",
        f"for (const auto & {row} : {table}) {{\n  if (!{row}.used) {{\n    continue;\n  }}\n{own.cpp()}\n}}",
    )


def over_functions(draft: Draft, block: Block, depth: int) -> None:
    """A list of functions, each of which creates."""
    makers, given, inner = draft.fresh("v"), draft.fresh("v"), block.nested(captured=[])
    items: list[Pair] = []
    for _ in range(2):
        body = Block(block.node, block.keep)
        body.texts = [Pair("topic", "topic")]
        statements(draft, body, DEPTH, 0)
        name = draft.fresh("maker")
        block.say(f"def {name}(topic):\n{body.py()}", "")
        items.append(Pair(name, f"[&](const std::string & topic) {{\n{body.cpp()}\n}}"))
    word = text(draft, inner, 2)
    block.say(*_drained(inner))
    block.say(
        f"{makers} = [{', '.join(i.py for i in items)}]\nfor {given} in {makers}:\n    {given}({word.py})",
        f"const std::vector<std::function<void(const std::string &)>> {makers} = {{{', '.join(i.cpp for i in items)}}};\n"
        f"for (const auto & {given} : {makers}) {{\n  {given}({word.cpp});\n}}",
    )


def _drained(block: Block) -> Pair:
    py, cpp = block.py(0), block.cpp(0)
    return Pair("" if py == "pass" else py, cpp)


def caught(draft: Draft, block: Block, depth: int) -> None:
    """Something is raised, sometimes, and caught."""
    name, test, given = draft.fresh("check"), condition(draft, block), text(draft, block)
    kind, wide = draft.pick(
        [
            ("std::runtime_error", "std::exception"),
            ("std::invalid_argument", "std::logic_error"),
            ("std::out_of_range", "std::out_of_range"),
        ]
    )
    raised = {
        "std::runtime_error": "RuntimeError",
        "std::invalid_argument": "ValueError",
        "std::out_of_range": "IndexError",
    }[kind]
    draft.define(
        f"def {name}(fine, what):\n    if not fine:\n        raise {raised}(what)\n    return what + '_fine'",
        f'std::string {name}(bool fine, const std::string & what)\n{{\n  if (!fine) {{\n    throw {kind}(what);\n  }}\n  return what + "_fine";\n}}',
    )
    tried, other = block.nested(), block.nested()
    fine = draft.fresh("v")
    tried.say(f"{fine} = {name}({test.py}, {given.py})", f"const std::string {fine} = {name}({test.cpp}, {given.cpp});")
    tried.remember(tried.texts, fine)
    statements(draft, tried, depth + 1, 0)
    statements(draft, other, depth + 1, 0)
    block.say(
        f"try:\n{tried.py()}\nexcept {raised if kind == wide else 'Exception'}:\n{other.py()}",
        f"try {{\n{tried.cpp()}\n}} catch (const {wide} & error) {{\n{other.cpp()}\n}}",
    )


def invalid_name(draft: Draft, block: Block, depth: int) -> None:
    bad, other = draft.pick(["a b", "a//b", "9to5", "trailing/", ""]), block.nested()
    statements(draft, other, DEPTH, 0)
    block.say(
        f"try:\n    {block.node.py}.create_publisher(String, {bad!r}, 10)\nexcept InvalidTopicNameException:\n{other.py()}",
        f'try {{\n  {block.node.call}create_publisher<std_msgs::msg::String>("{bad}", 10);\n'
        f"}} catch (const rclcpp::exceptions::InvalidTopicNameError &) {{\n{other.cpp()}\n}}",
    )


FLOW: Final[tuple[Statement, ...]] = (
    *(
        branch,
        branch,
        environment,
        over_list,
        over_list,
        over_numbers,
        over_map,
        over_table,
        over_functions,
        caught,
        invalid_name,
    ),
)
