# SPDX-License-Identifier: Apache-2.0
"""Which variables does a body have? They are copied, named twice, passed on and changed."""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Statement
from .values import number, text, words


def variable(draft: Draft, block: Block, depth: int) -> None:
    name, kind = draft.fresh("v"), draft.number(0, 2)
    if kind == 0:
        given = text(draft, block)
        block.say(
            f"{name} = {given.py}",
            f"{draft.pick(['const std::string', 'std::string', 'const auto', 'auto'])} {name} = {given.cpp};",
        )
        block.remember(block.texts, name)
    elif kind == 1:
        given = number(draft, block)
        block.say(f"{name} = {given.py}", f"{draft.pick(['const int', 'int', 'const auto'])} {name} = {given.cpp};")
        block.remember(block.numbers, name)
    else:
        given = words(draft, block)
        block.say(f"{name} = list({given.py})", f"const std::vector<std::string> {name} = {given.cpp};")
        block.remember(block.lists, name)


def counter(draft: Draft, block: Block, depth: int) -> None:
    """A number that changes."""
    name, step = draft.fresh("v"), number(draft, block)
    block.say(
        f"{name} = 1\n{name} += {step.py}\n{name} = {name} * 2", f"int {name} = 1;\n{name} += {step.cpp};\n{name} *= 2;"
    )
    block.remember(block.numbers, name)


def copied(draft: Draft, block: Block, depth: int) -> None:
    """A list that is changed through another name for it, or beside its copy."""
    one, two, more = draft.fresh("v"), draft.fresh("v"), text(draft, block)
    given = words(draft, block)
    block.say(f"{one} = list({given.py})", f"std::vector<std::string> {one} = {given.cpp};")
    py, cpp = draft.pick(
        [
            (f"list({one})", "auto"),
            (one, "auto &"),
            (one, "std::vector<std::string> &"),
            (f"{one}[:]", "std::vector<std::string>"),
        ]
    )
    block.say(f"{two} = {py}\n{two}.append({more.py})", f"{cpp} {two} = {one};\n{two}.push_back({more.cpp});")
    block.say("", f"(void){two};")
    block.remember(block.lists, one)
    block.remember(block.lists, two)


def passed(draft: Draft, block: Block, depth: int) -> None:
    """A list that a function changes, or its copy."""
    name, one, more = draft.fresh("extend"), draft.fresh("v"), text(draft, block)
    how = draft.pick(["", " &", " *"])
    given = words(draft, block)
    arrow = "->" if how == " *" else "."
    draft.define(
        f"def {name}(items, more):\n    items.append(more + '_added')\n    return len(items)",
        f"int {name}(std::vector<std::string>{how} items, const std::string & more)\n{{\n"
        f'  items{arrow}push_back(more + "_added");\n  return static_cast<int>(items{arrow}size());\n}}',
    )
    count = draft.fresh("v")
    block.say(
        f"{one} = list({given.py})\n{count} = {name}({one if how else f'list({one})'}, {more.py})",
        f"std::vector<std::string> {one} = {given.cpp};\nconst int {count} = {name}({'&' if how == ' *' else ''}{one}, {more.cpp});",
    )
    block.remember(block.lists, one)
    block.remember(block.numbers, count)


def settings(draft: Draft, block: Block, depth: int) -> None:
    """An object that is copied, named twice, or shared; then one of both is changed."""
    kind, one, two = draft.fresh("Settings"), draft.fresh("v"), draft.fresh("v")
    word, new = draft.word(), text(draft, block)
    draft.define(
        f"class {kind}:\n    def __init__(self):\n        self.topic = {word!r}\n        self.depth = 3",
        f'struct {kind}\n{{\n  std::string topic = "{word}";\n  int depth = 3;\n}};',
    )
    py, cpp, arrow = draft.pick(
        [
            (f"{two} = copy.copy({one})", f"{kind} {one};\n{kind} {two} = {one};", "."),
            (f"{two} = copy.copy({one})", f"auto {one} = {kind}();\nauto {two}{{{one}}};", "."),
            (f"{two} = {one}", f"{kind} {one};\nauto & {two} = {one};", "."),
            (f"{two} = {one}", f"auto {one} = std::make_shared<{kind}>();\nauto {two} = {one};", "->"),
            (
                f"{two} = copy.copy({one})",
                f"auto {one} = std::make_unique<{kind}>();\nauto {two} = std::make_shared<{kind}>(*{one});",
                "->",
            ),
        ]
    )
    block.say(
        f"{one} = {kind}()\n{py}\n{one}.topic = {new.py}\n{two}.depth += 1",
        f"{cpp}\n{one}{arrow}topic = {new.cpp};\n{two}{arrow}depth += 1;",
    )
    for held in (one, two):
        topic, count = draft.fresh("v"), draft.fresh("v")
        block.say(
            f"{topic} = {held}.topic\n{count} = {held}.depth",
            f"const std::string {topic} = {held}{arrow}topic;\nconst int {count} = {held}{arrow}depth;",
        )
        block.remember(block.texts, topic)
        block.remember(block.numbers, count)


DATA: Final[tuple[Statement, ...]] = (variable, variable, counter, copied, passed, settings)
