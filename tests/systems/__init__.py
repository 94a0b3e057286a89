# SPDX-License-Identifier: Apache-2.0
"""Launched systems as a whole: small workspaces, a command, and what comes of it."""
