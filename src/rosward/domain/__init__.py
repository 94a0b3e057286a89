# SPDX-License-Identifier: Apache-2.0
"""What a program can hold: abstract values, text with holes, alternatives, unknowns with their reasons, and the heap."""
