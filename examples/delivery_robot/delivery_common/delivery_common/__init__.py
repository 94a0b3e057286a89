# SPDX-License-Identifier: Apache-2.0
"""What the nodes of the delivery robot share: base classes, QoS profiles, names."""
