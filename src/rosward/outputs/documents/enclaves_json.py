# SPDX-License-Identifier: Apache-2.0
"""The ladder of enclaves and the suggestion, for a program: version 1, schema in `schemas/enclaves.schema.json`.

    {"schema_version": 1, "generator": {…}, "units": […], "start": {…}, "steps": […], "suggestion": {"steps": 3, "enclaves": […]}}

A step joins two groups by their numbers: below the number of units a unit, else the group that the step of that number, counted from there, made.
"""

from __future__ import annotations

from typing import Final

from rosward.enclaves.price import Price
from rosward.enclaves.privileges import Privilege
from rosward.enclaves.suggestion import JointEnclave, Suggestion, Surplus
from rosward.outputs.documents.json_text import json_text
from rosward.outputs.documents.rows import header

__all__ = ["enclaves_json"]

_SCHEMA_VERSION: Final = 1


def enclaves_json(suggestion: Suggestion) -> str:
    """The text of the document."""
    made = suggestion.ladder
    document = {
        **header(_SCHEMA_VERSION),
        "units": [{"enclave": u.enclave, "processes": list(u.processes), "fixed": u.fixed} for u in made.units],
        "start": _price(made.start),
        "steps": [
            {
                "joins": [step.left, step.right],
                "price": _price(step.price),
                "total": _price(step.total),
                "enclaves": step.enclaves,
            }
            for step in made.steps
        ],
        "knee": suggestion.knee,
        "needed": suggestion.needed,
        "suggestion": {
            "by": suggestion.wish.value,
            "limit": suggestion.limit,
            "met": suggestion.met,
            "steps": suggestion.cut.steps,
            "enclaves": [_enclave(enclave) for enclave in suggestion.enclaves],
        },
    }
    return json_text(document)


def _price(price: Price) -> dict[str, int]:
    return {"application": price.application, "system": price.system}


def _enclave(enclave: JointEnclave) -> dict[str, object]:
    return {
        "path": enclave.path,
        "fixed": enclave.fixed,
        "price": _price(enclave.price),
        "permissions_bytes": enclave.size,
        "too_large": enclave.too_large,
        "processes": [_process(process) for process in enclave.processes],
    }


def _process(process: Surplus) -> dict[str, object]:
    influenced = {} if process.influenced is None else {"influenced": list(process.influenced)}
    return {
        "process": process.process,
        "nodes": list(process.nodes),
        "not_needed": [_right(right, system=False) for right in process.application]
        + [_right(right, system=True) for right in process.system],
        **influenced,
    }


def _right(right: Privilege, *, system: bool) -> dict[str, object]:
    return {"kind": right.kind.value, "name": right.name, "pattern": "*" in right.name, "system": system}
