# SPDX-License-Identifier: Apache-2.0
"""What a tree starts: contexts, substitutions, conditions, actions, in the order of launch."""
