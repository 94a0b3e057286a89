# SPDX-License-Identifier: Apache-2.0
"""ros2lifecycle.api: clients of the services of lifecycle nodes.

Read from the branches humble, iron, jazzy and rolling of ros2cli.
"""
from _rosward import creator, reads_only, unknown
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState

@reads_only
def get_node_names(*, node, include_hidden_nodes=False):
    return unknown('live', 'nodes of the system')
@creator
def call_get_states(*, node, node_names):
    return _call(node, node_names, GetState, 'get_state')
@creator
def call_get_available_transitions(*, node, states):
    return _call(node, states, GetAvailableTransitions, 'get_available_transitions')
@creator
def call_get_transition_graph(*, node, states):
    return _call(node, states, GetAvailableTransitions, 'get_transition_graph')
@creator
def call_change_states(*, node, transitions):
    return _call(node, transitions, ChangeState, 'change_state')
def _call(node, names, type_, service):
    for name in names:
        node.create_client(type_, f'{name}/{service}')
    return unknown('message', f'answers of {service}')
