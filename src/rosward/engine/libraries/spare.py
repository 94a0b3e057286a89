# SPDX-License-Identifier: Apache-2.0
"""Where does an analysis have rosward's own models from? The first of a process from what is kept of others, a later one from the one before."""

from __future__ import annotations

from typing import Final

from rosward.engine.libraries.kept_models import KeptModels, kept_models
from rosward.engine.libraries.model_library import ModelLibrary
from rosward.models.tables import Models

__all__ = ["borrowed", "given_back"]

_SPARE: Final[list[ModelLibrary | KeptModels]] = []
"""rosward's own models as the analysis before left them; it is empty while they are in use. They and what they make never change."""


def borrowed(models: Models, *, net: bool) -> ModelLibrary | KeptModels:
    """Those, or a library in which nothing was asked for so far."""
    found = _SPARE.pop() if _SPARE else None
    if found is not None and found.is_of(models, net=net):
        return found
    return kept_models(models) or ModelLibrary(models, net=net)


def given_back(library: ModelLibrary | KeptModels) -> None:
    """For the next analysis: what nobody uses any more, and in which nothing went wrong."""
    if library.at_rest and not library.findings:
        _SPARE[:] = [library]
