# SPDX-License-Identifier: Apache-2.0
"""Text, and where it came from: files, packages, executables, imports."""
