# SPDX-License-Identifier: Apache-2.0
"""The graph as a picture, or as text that becomes one."""
