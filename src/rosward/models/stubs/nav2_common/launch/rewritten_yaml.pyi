# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch.rewritten_yaml."""

from nav2_common.launch import RewrittenYaml as RewrittenYaml
