# SPDX-License-Identifier: Apache-2.0
"""What is the same in every report? The page around the document, of which `assets/report.html.j2` is the template.

    rendered(flows=False)   "<!DOCTYPE html>…<title>…: ⟦nodes⟧ · rosward</title>…"

To render it and to compress the scripts takes longer than to analyse a small node, so that is done once for an installed rosward (`source/kept.py`).
"""

from __future__ import annotations

import base64
import hashlib
import json
from importlib import resources
from typing import Final

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup

from rosward._version import __version__
from rosward.outputs.report.packed import packed
from rosward.outputs.report.slots import SLOTS, slot

__all__ = ["rendered"]

_TEMPLATE: Final = "report.html.j2"


def rendered(*, flows: bool) -> str:
    """The page with an open place for each of `SLOTS`; `flows`: with the scripts for those."""
    environment = Environment(
        loader=FunctionLoader(_asset),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template(_TEMPLATE).render(
        asset=lambda name: Markup(_asset(name)),
        sha256=_sha256,
        version=__version__,
        flows=flows,
        packed=lambda text: Markup(packed(text)),
        texts=lambda names: json.dumps([_asset(name) for name in names]),
        **{name: Markup(slot(name)) for name in SLOTS},
    )


def _asset(name: str) -> str:
    """The text of a file in `assets/`; the names are those that the template itself has."""
    return resources.files("rosward.outputs.report").joinpath("assets", *name.split("/")).read_text(encoding="utf-8")


def _sha256(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
