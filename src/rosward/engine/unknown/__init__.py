# SPDX-License-Identifier: Apache-2.0
"""Code that is not known: what it may change, call and keep, and what is declared of it."""
