# SPDX-License-Identifier: Apache-2.0
"""What Python means: attributes, classes, items, operators, modules, exceptions, calls, generators."""
