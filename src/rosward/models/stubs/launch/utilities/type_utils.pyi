# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.type_utils.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import perform
from launch.substitution import Substitution

reads_only(__name__)


def is_substitution(x): return isinstance(x, Substitution)
def normalize_typed_substitution(value, data_type): return value
def perform_typed_substitution(context, value, data_type): ...
def get_typed_value(value, data_type, *, can_be_str=False): ...
def coerce_to_type(value, data_type=None, *, can_be_str=False): ...
