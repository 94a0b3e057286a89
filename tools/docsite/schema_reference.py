# SPDX-License-Identifier: Apache-2.0
"""Which fields has a JSON file? Written from its schema.

    "line": {"type": "integer", "minimum": 0, "description": "counted from 1; 0 for a file as a whole"}

becomes the row

    | `line` | integer | counted from 1; 0 for a file as a whole |
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["schema_reference"]

Schema = Mapping[str, Any]


def schema_reference(schema: Schema) -> str:
    """A table for the document, and one for each kind of record in it, in the order of the schema."""
    definitions: Mapping[str, Schema] = schema.get("$defs", {})
    records = {name: each for name, each in definitions.items() if "properties" in each}
    tables = [f"#### The document\n\n{_table(schema, definitions)}"]
    tables += [f"#### {name.replace('_', ' ')}\n\n{_table(each, definitions)}" for name, each in records.items()]
    return "\n".join(tables)


def _table(record: Schema, definitions: Mapping[str, Schema]) -> str:
    told = str(record.get("description", ""))
    required = set(record.get("required", ()))
    rows = ["| field | value | |", "|---|---|---|"]
    for name, field in record["properties"].items():
        note = str(field.get("description", "") or _description(field, definitions))
        optional = "" if name in required else "may be left out" + ("; " if note else "")
        rows.append(f"| `{name}` | {_kind(field, definitions)} | {optional}{_cell(note)} |")
    return (f"{told}\n\n" if told else "") + "\n".join(rows) + "\n"


def _description(field: Schema, definitions: Mapping[str, Schema]) -> str:
    """What the definition says that a field refers to; a record says it at its own table."""
    target = _target(field, definitions)
    return "" if target is None or "properties" in target else str(target.get("description", ""))


def _target(field: Schema, definitions: Mapping[str, Schema]) -> Schema | None:
    return definitions.get(str(field["$ref"]).rpartition("/")[2]) if "$ref" in field else None


def _kind(field: Schema, definitions: Mapping[str, Schema]) -> str:
    """The kind of value in a few words: `list of string`, a link to the record, the choices."""
    target = _target(field, definitions)
    if target is not None:
        name = str(field["$ref"]).rpartition("/")[2]
        return (
            f"[{name.replace('_', ' ')}](#{name.replace('_', '-')})"
            if "properties" in target
            else _kind(target, definitions)
        )
    if "const" in field:
        return f"`{_json(field['const'])}`"
    if "enum" in field:
        return " \\| ".join(f"`{_json(value)}`" for value in field["enum"])
    if "anyOf" in field or "oneOf" in field:
        return " \\| ".join(_kind(each, definitions) for each in field.get("anyOf", field.get("oneOf")))
    kind = field.get("type", "any")
    if kind == "array" and "items" in field:
        return f"list of {_kind(field['items'], definitions)}"
    if kind == "object" and "properties" in field:
        inner = ", ".join(f"`{name}`" for name in field["properties"])
        return f"object with {inner}"
    return " \\| ".join(kind) if isinstance(kind, list) else str(kind)


def _json(value: object) -> str:
    return value if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", " ")
