# SPDX-License-Identifier: Apache-2.0
"""The beginning of a declaration: of a program that nobody knows, of one that ran, of one whose source is there and not analysed."""
