# SPDX-License-Identifier: Apache-2.0
"""Is this the name of a topic, a node, a namespace or an enclave?

    validate_full("/left//cmd")   -> "a fully qualified name must not hold '//'"
    validate_full("/left/*/cmd")  -> None, for most fillings of the hole are fine

The rules are those of rcl (validate_topic_name.c, validate_enclave_name.c) and rmw (validate_full_topic_name.c,
validate_namespace.c, validate_node_name.c), the same from humble to rolling. Each function returns why a name is
invalid, None if it is valid. A hole, `*`, may be filled with anything: only what no filling can repair is invalid.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.holes import HOLE, Holed

MAX_TOPIC: Final = 247  # 255 less 8 reserved for prefixes (rmw/validate_full_topic_name.h)
MAX_NAMESPACE: Final = 245  # less 2 for the shortest "/x" after it (rmw/validate_namespace.h)
MAX_NODE_NAME: Final = 255  # rmw/validate_node_name.h; an enclave has the same limit (rcl/validate_enclave_name.h)

_ROOT: Final = ("/", "*/")  # the hole of the second can only be empty
_HOLES: Final = re.compile(r"\*+")
_FULL_CHARACTERS: Final = re.compile(r"[A-Za-z0-9_/*]*")
_NODE_CHARACTERS: Final = re.compile(r"[A-Za-z0-9_*]*")
_BAD_TOKEN: Final = re.compile(r"/([/0-9])")


def collapse(name: Holed) -> Holed:
    """`name` with one hole for each run of holes."""
    return Holed(_HOLES.sub(HOLE, name))


def validate_name(name: Holed) -> str | None:
    """Why `name` cannot be a topic or service name in a program, relative ones too (rcl validate_topic_name.c)."""
    name = collapse(name)
    if name.startswith("*~"):
        return validate_name(Holed(name[1:]))  # a tilde stands first or nowhere: the hole is empty
    if not name:
        return "a topic name must not be empty"
    if name[0].isdigit() and name[0].isascii():
        return "a token of a topic name must not start with a number"
    if name.endswith("/"):
        return "a topic name must not end with '/'"
    reason = _validate_characters(name)
    if reason is not None:
        return reason
    token = re.search(r"/[0-9]", name)
    if token is not None:
        return "a token of a topic name must not start with a number"
    # rcl does not look at the last character: "~x" passes, "~xy" does not
    if re.match(r"~[^/*]", name) and name[2:].replace(HOLE, ""):
        return "'~' in a topic name must be followed by '/'"
    return None


def _validate_characters(name: Holed) -> str | None:
    """The characters and the balance of braces of `name`; after a hole, whether a brace is open is not known (None)."""
    inside: bool | None = False
    for index, char in enumerate(name):
        if char == HOLE:
            inside = None
        elif char == "/":
            if inside:
                return "a substitution must hold only alphanumerics and '_'"
            inside = False
        elif char == "~":
            if index:
                return "'~' must be the first character of a topic name"
        elif char == "{":
            if inside:
                return "a substitution must hold only alphanumerics and '_'"
            inside = True
        elif char == "}":
            if inside is False:
                return "unbalanced braces in a topic name"
            inside = False
        elif not (char.isascii() and (char.isalnum() or char == "_")):
            if inside:
                return "a substitution must hold only alphanumerics and '_'"
            return "a topic name must hold only alphanumerics, '_', '/', '~', '{' and '}'"
        elif char.isdigit() and inside and name[index - 1] == "{":
            return "a substitution must not start with a number"
    return "unbalanced braces in a topic name" if inside else None


def validate_full(name: Holed) -> str | None:
    """Why `name` cannot be the full name of a topic or service (rmw validate_full_topic_name.c)."""
    return _validate_full(name, "a fully qualified name", MAX_TOPIC)


def validate_namespace(namespace: Holed) -> str | None:
    """Why `namespace` cannot be a full namespace (rmw validate_namespace.c)."""
    return None if collapse(namespace) in _ROOT else _validate_full(namespace, "a namespace", MAX_NAMESPACE)


def validate_enclave(enclave: Holed) -> str | None:
    """Why `enclave` cannot be an enclave (rcl validate_enclave_name.c)."""
    return None if collapse(enclave) in _ROOT else _validate_full(enclave, "an enclave", MAX_NODE_NAME)


def validate_node_name(name: Holed) -> str | None:
    """Why `name` cannot be the name of a node, without namespace (rmw validate_node_name.c)."""
    if not name:
        return "a node name must not be empty"
    if not _NODE_CHARACTERS.fullmatch(name):
        return "a node name must hold only alphanumerics and '_'"
    if name[0].isdigit():
        return "a node name must not start with a number"
    return _too_long(name, "a node name", MAX_NODE_NAME)


def _validate_full(name: Holed, what: str, limit: int) -> str | None:
    if not name:
        return f"{what} must not be empty"
    if name[0] not in "/*":
        return f"{what} must start with '/'"
    if name.endswith("/"):
        return f"{what} must not end with '/'"
    if not _FULL_CHARACTERS.fullmatch(name):
        return f"{what} must hold only alphanumerics, '_' and '/'"
    token = _BAD_TOKEN.search(name)
    if token is not None:
        return f"{what} must not hold '//'" if token[1] == "/" else f"a token of {what} must not start with a number"
    return _too_long(name, what, limit)


def _too_long(name: Holed, what: str, limit: int) -> str | None:
    return f"{what} must not be longer than {limit} characters" if len(name.replace(HOLE, "")) > limit else None
