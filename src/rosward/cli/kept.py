# SPDX-License-Identifier: Apache-2.0
"""Which results of earlier runs does a command use? Those in the cache folder of the user, unless they are not wanted."""

from __future__ import annotations

TYPE_CHECKING = False  # not from typing: this decides what else is loaded
if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable
    from typing import Any

    from rosward.cache.store import Store
    from rosward.result import Result

__all__ = ["add_cache", "known_or", "results_folder", "store_of"]


def add_cache(parser: argparse.ArgumentParser) -> None:
    """Whether results of earlier runs are used."""
    parser.add_argument("--no-cache", action="store_true", help="neither use nor keep results of earlier runs")


def store_of(options: argparse.Namespace) -> Store | None:
    """The results of earlier runs; None where they are not wanted, or there is no place for them."""
    if options.no_cache:
        return None
    folder = results_folder()
    if folder is None:
        return None
    from rosward.cache.store import Store

    return Store(folder)


def results_folder() -> str | None:
    """Where results of earlier runs are; None where there is no place for them."""
    from rosward.source.kept import cache_folder

    return cache_folder()


def known_or(compute: Callable[[], Result], store: Store | None, arguments: dict[str, Any]) -> Result:
    """The result that the store has of an extraction with these arguments; else that which is computed, and then kept."""
    if store is None:
        return compute()
    from rosward.cache.results import keep_result, kept_result, question_of
    from rosward.source.disk import watching

    question = question_of(**arguments)
    known = kept_result(store, question)
    if known is not None:
        return known
    with watching() as trace:
        found = compute()
    found = keep_result(store, question, found, trace)
    store.close()
    return found
