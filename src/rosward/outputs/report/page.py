# SPDX-License-Identifier: Apache-2.0
"""How do the document and the assets become one file that needs nothing else?

    report_html(network, Background(root, systems))  ->  "<!DOCTYPE html>…<script type="text/plain" id="report">eNq9…</script>…"

The file works offline and loads nothing: its Content-Security-Policy forbids all but its own style and scripts, which it names by their
hashes. The template (`assets/report.html.j2`) says which scripts and styles there are. Document and scripts are compressed (`packed`); one small
script that is not, `assets/js/unpack.js`, takes them out and starts them. A name out of the sources, however it is made, is a string in the
document and stays text.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Final

from rosward.network.checks import UnknownNames
from rosward.network.counts import counts_of
from rosward.network.graph import Network
from rosward.outputs.background import Background
from rosward.outputs.graphs.svg import graph_svg
from rosward.outputs.pictures import Pictures
from rosward.outputs.report.document import report_document
from rosward.outputs.report.packed import packed
from rosward.outputs.report.slots import filled
from rosward.outputs.writing import File, Material
from rosward.safe import encodable, xml_text
from rosward.source.kept import kept

__all__ = ["document_text", "files", "report_html"]

_LARGEST_FALLBACK: Final = 300_000
_NOTHING: Final = Background()


def files(material: Material) -> Iterator[File]:
    """The files of the format `html`."""
    background = (material.background or _NOTHING)._replace(widened=material.widened)
    yield "report.html", report_html(material.network, background, material.unknown, material.pictures)


def report_html(
    network: Network,
    background: Background = _NOTHING,
    unknown: UnknownNames = "deny",
    pictures: Pictures | None = None,
) -> str:
    """The page. `unknown` is what the policies in it say for a name that is not known; `pictures` is what was drawn so far."""
    document = report_document(network, background, unknown)
    count = counts_of(network).nodes
    flows = "flows" in document
    frame = kept("flow_report" if flows else "report", lambda: _frame(flows=flows).encode())
    texts = {
        "nodes": f"{count} node{'' if count == 1 else 's'}",
        "files": str(network.files),
        "distro": xml_text(network.distro),
        "fallback": _fallback(network, pictures),
        "document": packed(document_text(document)),
    }
    return filled(_frame(flows=flows) if frame is None else frame.decode(), texts)


def _frame(*, flows: bool) -> str:
    from rosward.outputs.report.frame import rendered

    return rendered(flows=flows)


def document_text(document: dict[str, object]) -> str:
    """The document as JSON."""
    return encodable(json.dumps(document, ensure_ascii=False, allow_nan=False, separators=(",", ":")))


def _fallback(network: Network, pictures: Pictures | None) -> str:
    """The still drawing for where no script runs; nothing where it is too large to be of use."""
    drawing = graph_svg(network, pictures=pictures)
    return drawing if len(drawing) <= _LARGEST_FALLBACK else ""
