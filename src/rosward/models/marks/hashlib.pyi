# SPDX-License-Identifier: Apache-2.0
"""hashlib: digests."""

from _rosward import pure

pure(__name__)
