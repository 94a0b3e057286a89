# SPDX-License-Identifier: Apache-2.0
"""Threads, locks, atomics, futures."""
