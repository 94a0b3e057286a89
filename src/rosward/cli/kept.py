# SPDX-License-Identifier: Apache-2.0
"""Which results of earlier runs does a command use? Those in a cache of the user, unless that is not wanted."""

from __future__ import annotations

import argparse
import os
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from rosward.cache.store import Store
    from rosward.result import Result

__all__ = ["add_cache", "known_or", "store_of"]


def add_cache(parser: argparse.ArgumentParser) -> None:
    """Where results of earlier runs are."""
    parser.add_argument(
        "--no-cache",
        action="store_true",
        default=bool(os.environ.get("ROSWARD_NO_CACHE")),
        help="do not use or keep results of earlier runs (also: ROSWARD_NO_CACHE)",
    )
    parser.add_argument(
        "--cache-dir",
        metavar="DIR",
        default=os.environ.get("ROSWARD_CACHE_DIR") or None,
        help="folder for results of earlier runs (default: ROSWARD_CACHE_DIR, else `rosward` in the cache folder of the user)",
    )


def store_of(options: argparse.Namespace) -> Store | None:
    """The cache that the options name; None where none is wanted, or there is no place for one."""
    if options.no_cache:
        return None
    from rosward.cache.store import Store, usual_folder

    folder = options.cache_dir or usual_folder()
    return None if folder is None else Store(os.path.abspath(folder))  # noqa: PTH100


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
