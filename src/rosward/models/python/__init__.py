# SPDX-License-Identifier: Apache-2.0
"""What does Python come with? Builtins, containers, operators, texts, the standard library."""
