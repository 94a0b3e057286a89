# SPDX-License-Identifier: Apache-2.0
"""How one goes through elements, and what all containers have in common."""
