# SPDX-License-Identifier: Apache-2.0
"""What runs later: which callbacks, in which rounds, and which of them need not run again."""
