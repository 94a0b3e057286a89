# SPDX-License-Identifier: Apache-2.0
"""How text that others wrote gets into a document without breaking it.

Names, paths and reasons come from the sources that are analysed, so they may hold anything: quotes, tags, `--`, escape
sequences of a terminal, characters that XML cannot hold. Each function here makes any string safe for one place.
"""

from __future__ import annotations

import json
import re
from typing import Final

__all__ = ["encodable", "json_escaped", "printable", "toml_string", "xml_attribute", "xml_comment", "xml_text"]

_NOT_XML: Final = "[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"
_SURROGATE: Final = "[\ud800-\udfff]"
_CONTROL: Final = (
    "[\x00-\x1f\x7f-\x9f\xad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u2028-\u202e\u2060-\u206f\u3164\ud800-\udfff"
    "\ufe00-\ufe0f\ufeff\uffa0\ufff0-\ufffb\U0001bca0-\U0001bca3\U0001d173-\U0001d17a\U000e0000-\U000e0fff]"
)
"""What ends a line, turns a line round, or cannot be seen (Unicode's Default_Ignorable_Code_Point), so that two names look the same.

These patterns are slow to compile, and most texts need none: `re` compiles and keeps them when the first text does.
"""


def encodable(text: str) -> str:
    """The text with lone surrogates, which UTF-8 cannot hold, written as `\\udXXX`."""
    return text if text.isascii() else re.sub(_SURROGATE, lambda m: f"\\u{ord(m.group()):04x}", text)


def printable(text: str) -> str:
    """One line for a terminal or a page: control characters, line ends, direction marks and what has no width become visible escapes."""
    return text if _is_plain(text) else re.sub(_CONTROL, _escape, text)


def xml_text(text: str) -> str:
    """The text as the content of an element. What cannot be seen is written as a reference: it stays what it is, and who looks sees it."""
    plain = _is_plain(text)
    kept = text if plain else re.sub(_NOT_XML, "\ufffd", text)
    kept = kept.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return kept if plain else re.sub(_CONTROL, _reference, kept)


def xml_attribute(text: str) -> str:
    """The text as the value of an attribute, without the quotes around it."""
    return xml_text(text).replace('"', "&quot;").replace("\n", "&#10;").replace("\t", "&#9;")


def json_escaped(document: str) -> str:
    """A JSON document in which what cannot be seen, or is no character, is an escape: a reader of JSON gets what was there before."""
    plain = document.isascii() and "\x7f" not in document
    return document if plain else re.sub(_CONTROL, _json_escape, document)


def toml_string(text: str) -> str:
    """The text as a basic string of TOML, quotes included. It has the escapes of JSON, but no pairs of surrogates."""
    quoted = json.dumps(encodable(text), ensure_ascii=False)
    return re.sub(_CONTROL, lambda m: f"\\U{ord(m.group()):08X}", quoted)


def xml_comment(text: str) -> str:
    """A whole comment with this text: in it no two hyphens may follow each other, nor may one stand at the end."""
    shown = printable(text)
    kept = re.sub("-(?=-)", "- ", shown if _is_plain(shown) else re.sub(_NOT_XML, "\ufffd", shown))
    return f"<!-- {kept} -->"


def _is_plain(text: str) -> bool:
    """Whether a text is safe but for the marks of a language: it has visible ASCII and spaces alone."""
    return text.isascii() and text.isprintable()


def _reference(match: re.Match[str]) -> str:
    return match.group() if match.group() in "\n\t" else f"&#{ord(match.group())};"


def _json_escape(match: re.Match[str]) -> str:
    """Outside of its texts JSON has no such character but the end of a line, and in them none of those."""
    return match.group() if match.group() == "\n" else json.dumps(match.group())[1:-1]


def _escape(match: re.Match[str]) -> str:
    code = ord(match.group())
    if code < 0x100:
        return f"\\x{code:02x}"
    return f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"
