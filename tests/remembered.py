# SPDX-License-Identifier: Apache-2.0
"""Which analyses of `examples/` were done before? What is read and asked again in the same way is not computed again.

    pytestmark = pytest.mark.usefixtures("remembered")

Only of the examples, which no test changes, and where no other file is named: everything else is analysed each time.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Final

from rosward import Result, pipeline

EXAMPLES: Final = Path(__file__).resolve().parent.parent / "examples"
_extract: Final = pipeline.extract
_results: Final[dict[str, Result]] = {}


def extract(*paths: str | os.PathLike[str], progress: Any = None, **options: Any) -> Result:
    """As `rosward.extract`, which it calls for what was not asked before."""
    if not paths or not all(Path(path).resolve().is_relative_to(EXAMPLES) for path in paths) or _names_a_file(options):
        return _extract(*paths, progress=progress, **options)
    asked = repr(([os.path.abspath(path) for path in paths], sorted(options.items())))  # noqa: PTH100
    if asked not in _results:
        _results[asked] = _extract(*paths, progress=progress, **options)
    return _results[asked]


def _names_a_file(options: dict[str, Any]) -> bool:
    """Whether something else is read than what stands under the paths."""
    request, assigned = options.get("request"), options.get("assigned")
    return bool(
        (request is not None and (request.params or not all(launch.package for launch in request.launches)))
        or (assigned is not None and assigned.file)
        or options.get("launch")
        or options.get("models")
        or options.get("underlays")
    )
