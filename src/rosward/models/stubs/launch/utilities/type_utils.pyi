# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.type_utils.

Read from launch 3.7.0, with what humble had before it.
"""

import yaml

from _rosward.launch import perform
from launch.substitution import Substitution


def is_substitution(x): return isinstance(x, Substitution)
def normalize_typed_substitution(value, data_type): return value


def perform_typed_substitution(context, value, data_type):
    if isinstance(value, (bool, int, float, str)):
        return value
    items = [value] if isinstance(value, Substitution) else list(value)
    if all(isinstance(item, (str, Substitution)) for item in items) and any(isinstance(item, Substitution) for item in items):
        return get_typed_value(perform(value), data_type)
    return [item if isinstance(item, (bool, int, float, str)) else perform(item) for item in items]


def get_typed_value(value, data_type, *, can_be_str=False):
    if isinstance(value, list):
        return [coerce_to_type(item, None, can_be_str=can_be_str) for item in value]
    return coerce_to_type(value, data_type, can_be_str=can_be_str)


def coerce_to_type(value, data_type=None, *, can_be_str=False):
    if data_type is str or not value:
        return value
    try:
        if data_type is int:
            return int(value)
        if data_type is float:
            return float(value)
        if data_type is bool and value in ("0", "1"):
            return value == "1"
        return yaml.safe_load(value)
    except Exception:
        if can_be_str:
            return value
        raise
