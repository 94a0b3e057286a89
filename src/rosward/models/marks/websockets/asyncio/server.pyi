# SPDX-License-Identifier: Apache-2.0
"""websockets.asyncio.server."""

from websockets import serve
