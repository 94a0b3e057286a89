# SPDX-License-Identifier: Apache-2.0
"""launch.utilities.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import perform
from launch.substitution import Substitution
from launch.substitutions import TextSubstitution


def is_a(obj, entity_type): return isinstance(obj, entity_type)
def is_a_subclass(obj, entity_type): return isinstance(obj, entity_type)
@reads_only
def isclassinstance(obj) -> bool: ...
@reads_only
def ensure_argument_type(argument, types, argument_name, caller=None) -> None: ...
def perform_substitutions(context, subs): return perform(subs)


def normalize_to_list_of_substitutions(subs):
    if isinstance(subs, str):
        return [TextSubstitution(text=subs)]
    if isinstance(subs, Substitution):
        return [subs]
    return [s if isinstance(s, Substitution) else TextSubstitution(text=str(s)) for s in subs]


def normalize_to_list_of_entities(entities): return list(entities)
@reads_only
def visit_all_entities_and_collect_futures(entity, context): ...
