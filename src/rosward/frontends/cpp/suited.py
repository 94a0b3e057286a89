# SPDX-License-Identifier: Apache-2.0
"""What of C++ does the grammar of the parser not know, and what can stand in its place, as wide and with the same meaning?

goal_ = typename ActionT::Goal();        goal_ =          ActionT::Goal();
new Cell * [size]                        new Cell   [size]
public slots:                            public      :
template class Tree<Node>;               nothing: it runs nothing
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.tokens import blank

_TYPENAME: Final = re.compile(r"(?:(?<==)|(?<=\breturn))[ \t]*\btypename\b")
_NEW_POINTERS: Final = re.compile(r"(?<=\bnew)([ \t]+[A-Za-z_][\w:]*)([ \t]*\*[ \t*]*)(?=\[)")
_SLOTS: Final = re.compile(r"(?:(?<=\bpublic)|(?<=\bprivate)|(?<=\bprotected))[ \t]+slots\b(?=[ \t]*:)")
_SIGNALS: Final = re.compile(r"^([ \t]*)signals(?=[ \t]*:[^:])", re.MULTILINE)
_INSTANTIATION: Final = re.compile(
    r"^[ \t]*(?:extern[ \t]+)?template[ \t]+(?:class|struct)\b[^;{}()]{0,500};", re.MULTILINE
)


def suited(text: str) -> str:
    """The text as the grammar likes it, each character where it was."""
    if "typename" in text:
        text = _TYPENAME.sub(_blank, text)
    if "new" in text:
        text = _NEW_POINTERS.sub(lambda found: found[1] + " " * len(found[2]), text)
    if "slots" in text:
        text = _SLOTS.sub(_blank, text)
    if "signals" in text:
        text = _SIGNALS.sub(r"\1public ", text)
    if "template" in text:
        text = _INSTANTIATION.sub(_blank, text)
    return text


def _blank(found: re.Match[str]) -> str:
    return blank(found[0])
