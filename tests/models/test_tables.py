# SPDX-License-Identifier: Apache-2.0
"""Which modules are imported for models in code?"""

import json

import pytest

from rosward.models import tables


@pytest.mark.parametrize("kept", [{"builtins.len": "this"}, {"builtins.len": "rosward.models_of_others"}, {}])
def test_what_is_kept_names_no_module_of_others(monkeypatch: pytest.MonkeyPatch, kept: dict[str, str]) -> None:
    monkeypatch.setattr(tables, "_OWN_NATIVES", [])
    monkeypatch.setattr(tables, "kept", lambda _name, _make: json.dumps(kept).encode())
    found = tables.own_models().natives
    assert found["builtins.len"].__module__.startswith("rosward.models.")
