# SPDX-License-Identifier: Apache-2.0
"""websockets.server."""

from websockets import serve
