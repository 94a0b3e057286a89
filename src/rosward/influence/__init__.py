# SPDX-License-Identifier: Apache-2.0
"""Information flow across a system: what reaches what, by which path, and which rules that breaks."""
