# SPDX-License-Identifier: Apache-2.0
"""Files that were changed by chance go the whole way without harm; `ROSWARD_MUTATIONS=20000` tries more of them than by default."""

from __future__ import annotations

import os

from hostile.fuzz import fuzz


def test_changed_files_hurt_nobody() -> None:
    count = int(os.environ.get("ROSWARD_MUTATIONS", "15"))
    failures = fuzz(count, seed=int(os.environ.get("ROSWARD_SEED", "1")), slow=60.0)
    assert [(f.changed.seed, f.error) for f in failures] == []
