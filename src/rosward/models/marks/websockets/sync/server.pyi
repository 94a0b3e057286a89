# SPDX-License-Identifier: Apache-2.0
"""websockets.sync.server."""

from websockets import serve
