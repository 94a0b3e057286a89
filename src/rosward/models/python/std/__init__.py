# SPDX-License-Identifier: Apache-2.0
"""The standard library, where a stub cannot say it."""
