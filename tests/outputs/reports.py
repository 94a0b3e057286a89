# SPDX-License-Identifier: Apache-2.0
"""Documents of the report for the tests: made of a network, checked against the schema, and easy to look into."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any, Final

import jsonschema

from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.report.document import report_document
from rosward.outputs.report.page import document_text

SCHEMA: Final = json.loads((resources.files("rosward.outputs") / "schemas" / "report.schema.json").read_text())
VALIDATOR: Final = jsonschema.Draft202012Validator(SCHEMA)
NOTHING: Final = Background()
_KINDS: Final = {"n": "nodes", "t": "endpoints", "e": "entities", "c": "enclaves", "r": "rules", "f": "findings"}


class Report:
    """A document as the page holds it, with what its ids mean."""

    def __init__(self, network: Network, background: Background = NOTHING, **more: Any) -> None:
        self.text = document_text(report_document(network, background, **more))
        self.text.encode()
        self.document: dict[str, Any] = json.loads(self.text)
        VALIDATOR.validate(self.document)
        self._rows = {row["id"]: row for kind in _KINDS.values() for row in self.document[kind]}

    def __getitem__(self, key: str) -> Any:
        return self.document[key]

    def row(self, id_: str) -> dict[str, Any]:
        """What an id means."""
        row: dict[str, Any] = self._rows[id_]
        return row

    def node(self, fqn: str) -> dict[str, Any]:
        """The one node of this name."""
        (row,) = (row for row in self["nodes"] if row["fqn"] == fqn)
        return dict(row)

    def endpoint(self, name: str, kind: str = "topic") -> dict[str, Any]:
        """The endpoint of this name."""
        (row,) = (row for row in self["endpoints"] if (row["kind"], row["name"]) == (kind, name))
        return dict(row)

    def entity(self, node: str, kind: str, name: str) -> dict[str, Any]:
        """The one entity of this kind and name that a node has."""
        entities = (self.row(id_) for id_ in self.node(node)["entities"])
        (row,) = (row for row in entities if (row["kind"], row["name"]) == (kind, name))
        return row

    def subjects(self, code: str) -> list[list[str]]:
        """What each finding of a code belongs to, in words: `/talker`, `topic /chatter`, `publisher /chatter of /talker`."""
        return [[self._word(i) for i in f["subjects"]] for f in self["findings"] if f["code"] == code]

    def _word(self, id_: str) -> str:
        row = self.row(id_)
        if id_.startswith("n"):
            return str(row["fqn"])
        if id_.startswith("t"):
            return f"{row['kind']} {row['name']}"
        return f"{row['kind']} {row['name']} of {self.row(row['node'])['fqn']}"
