# SPDX-License-Identifier: Apache-2.0
"""What was drawn so far, so that a graph that several formats show is drawn once."""

from __future__ import annotations

from collections.abc import Callable
from typing import final

__all__ = ["Pictures"]


@final
class Pictures:
    """Drawings by the text that was drawn, for one writing of all formats."""

    def __init__(self) -> None:
        self._drawn: dict[str, str] = {}

    def of(self, text: str, draw: Callable[[], str]) -> str:
        """The drawing of a text in the language of Graphviz, which `draw` makes where it is not there yet."""
        found = self._drawn.get(text)
        if found is None:
            found = self._drawn[text] = draw()
        return found
