# SPDX-License-Identifier: Apache-2.0
"""The only language that the engine knows: structured blocks of simple operations over numbered registers."""
