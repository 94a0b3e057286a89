# SPDX-License-Identifier: Apache-2.0
"""Two states of one system compared: nodes, entities and rights that came and went."""
