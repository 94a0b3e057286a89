# SPDX-License-Identifier: Apache-2.0
"""websockets.asyncio.client."""

from websockets import connect
