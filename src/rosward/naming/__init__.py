# SPDX-License-Identifier: Apache-2.0
"""From abstract values to the names of ROS: command line, options, final name, and the nodes that a log of effects makes."""
