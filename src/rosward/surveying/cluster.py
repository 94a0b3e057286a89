# SPDX-License-Identifier: Apache-2.0
"""How do the workers of a Dask cluster analyse repositories?

    with cluster("tcp://10.0.0.1:8786") as executor: …

A worker that is gone costs the tasks that it had another attempt elsewhere: the scheduler sees to that. Scheduler, workers and whoever asks send each
other Python objects, so all of them have to be trusted; of ours there are texts and bytes alone.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from importlib.util import find_spec
from typing import Final

from rosward.surveying.repositories import SurveyError

__all__ = ["cluster"]

_PATIENCE: Final = 15.0
"""Seconds in which a scheduler answers."""


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """An executor that runs on the workers of a scheduler. Raises SurveyError where none answers."""
    if find_spec("distributed") is None:
        raise SurveyError("--scheduler needs additional packages: pip install 'rosward[survey,dask]'")
    from distributed import Client

    _silence()
    try:
        client = Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError, ImportError) as error:  # a timeout is an OSError
        raise SurveyError(f"no Dask scheduler answers at {address}: {error}") from error
    with client:
        executor: Executor = client.get_executor(pure=False)
        yield executor


def _silence() -> None:
    """What the library logs of a lost scheduler is a traceback; whoever asks is told in a line."""
    for name in list(logging.root.manager.loggerDict):
        if name.partition(".")[0] == "distributed":
            logging.getLogger(name).setLevel(logging.CRITICAL)
