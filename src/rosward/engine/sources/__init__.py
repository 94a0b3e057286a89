# SPDX-License-Identifier: Apache-2.0
"""What the engine asks of sources, and what it has read of them."""
