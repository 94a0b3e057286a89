# SPDX-License-Identifier: Apache-2.0
"""launch_ros.utilities.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from _rosward import reads_only

@reads_only
def evaluate_parameters(context, parameters): ...
def normalize_parameters(parameters): return parameters
def normalize_remap_rule(remap_rule): return remap_rule
def normalize_remap_rules(remap_rules): return remap_rules
@reads_only
def to_parameters_list(context, node_name, namespace, evaluated_parameters): ...
def is_root_namespace(ns): return ns == "/"
def is_namespace_absolute(ns): return ns.startswith("/")
@reads_only
def add_node_name(context, node_name) -> None: ...
@reads_only
def get_node_name_count(context, node_name) -> int: ...


def make_namespace_absolute(ns):
    return ns if ns.startswith("/") else "/" + ns


def prefix_namespace(base_ns, ns):
    if base_ns is None or ns is None or ns.startswith("/"):
        return base_ns if ns is None else ns
    if ns == "":
        return base_ns
    return base_ns.rstrip("/") + "/" + ns
