# SPDX-License-Identifier: Apache-2.0
"""websockets.client."""

from websockets import connect
