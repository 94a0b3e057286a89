# SPDX-License-Identifier: Apache-2.0
"""What is analysed, in which order, and what does each process do? The way from folders to the nodes of all programs."""
