# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch.has_node_params."""

from nav2_common.launch import HasNodeParams as HasNodeParams
