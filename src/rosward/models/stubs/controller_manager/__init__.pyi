# SPDX-License-Identifier: Apache-2.0
"""controller_manager."""
