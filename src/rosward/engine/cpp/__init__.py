# SPDX-License-Identifier: Apache-2.0
"""C++, as the engine runs it."""
