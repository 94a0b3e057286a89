# SPDX-License-Identifier: Apache-2.0
"""How a program runs: the abstract interpreter of the intermediate representation."""
