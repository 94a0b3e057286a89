# SPDX-License-Identifier: Apache-2.0
"""The builtin containers, for other modules; their methods stand in `lists.py`, `dicts.py` and `sets.py`."""

from __future__ import annotations

from rosward.models.python.containers.dicts import key_of, look_up, store
from rosward.models.python.containers.lists import element, new_tuple, order
from rosward.models.python.containers.sets import combine, new_set

__all__ = ["combine", "element", "key_of", "look_up", "new_set", "new_tuple", "order", "store"]
