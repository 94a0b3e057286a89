# SPDX-License-Identifier: Apache-2.0
"""How do the document and the assets become one file that needs nothing else?

    report_html(network, Background(root, systems))  ->  "<!DOCTYPE html>…<script type="text/plain" id="report">eNq9…</script>…"

The file works offline and loads nothing: its Content-Security-Policy forbids all but its own style and scripts, which it names by their
hashes. The template (`assets/report.html.j2`) says which scripts and styles there are. Document and scripts are compressed (`packed`); one small
script that is not, `assets/js/unpack.js`, takes them out and starts them. A name out of the sources, however it is made, is a string in the
document and stays text.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Iterator
from importlib import resources
from typing import Final

from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup

from rosward.network.checks import UnknownNames
from rosward.network.graph import Network
from rosward.outputs.graphs.svg import graph_svg
from rosward.outputs.report.background import Background
from rosward.outputs.report.document import report_document
from rosward.outputs.report.packed import packed
from rosward.outputs.writing import File, Material
from rosward.safe import encodable, printable

__all__ = ["document_text", "files", "report_html"]

_TEMPLATE: Final = "report.html.j2"
_LARGEST_FALLBACK: Final = 300_000
_NOTHING: Final = Background()


def files(material: Material) -> Iterator[File]:
    """The files of the format `html`."""
    background = (material.background or _NOTHING)._replace(widened=material.widened)
    yield "report.html", report_html(material.network, background, material.unknown)


def report_html(network: Network, background: Background = _NOTHING, unknown: UnknownNames = "deny") -> str:
    """The page. `unknown` is what the policies in it say for a name that is not known."""
    document = report_document(network, background, unknown)
    environment = Environment(
        loader=FunctionLoader(_asset),
        autoescape=True,
        finalize=_harmless,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    return environment.get_template(_TEMPLATE).render(
        asset=lambda name: Markup(_asset(name)),
        sha256=_sha256,
        report=document,
        packed=lambda text: Markup(packed(text)),
        texts=lambda names: json.dumps([_asset(name) for name in names]),
        document=document_text(document),
        fallback=Markup(_fallback(network)),
    )


def document_text(document: dict[str, object]) -> str:
    """The document as JSON."""
    return encodable(json.dumps(document, ensure_ascii=False, allow_nan=False, separators=(",", ":")))


def _asset(name: str) -> str:
    """The text of a file in `assets/`; the names are those that the template itself has."""
    return resources.files("rosward.outputs.report").joinpath("assets", *name.split("/")).read_text(encoding="utf-8")


def _sha256(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _fallback(network: Network) -> str:
    """The still drawing for where no script runs; nothing where it is too large to be of use."""
    drawing = graph_svg(network)
    return drawing if len(drawing) <= _LARGEST_FALLBACK else ""


def _harmless(value: object) -> object:
    """What Jinja writes for an expression: text without control characters and direction marks, nothing for None."""
    if isinstance(value, Markup):
        return value
    return "" if value is None else printable(str(value))
