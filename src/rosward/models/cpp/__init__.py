# SPDX-License-Identifier: Apache-2.0
"""What rosward knows of the C++ standard library, in code."""
