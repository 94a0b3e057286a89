# SPDX-License-Identifier: Apache-2.0
"""websockets.sync.client."""

from websockets import connect
