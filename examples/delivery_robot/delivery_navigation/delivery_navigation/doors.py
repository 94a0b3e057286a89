# SPDX-License-Identifier: Apache-2.0
"""Opens the doors of the building, once one is in the way."""

from delivery_common.names import DOOR_SERVICE
from delivery_interfaces.srv import OpenDoor


class DoorOpener:
    """The robot's hand on the door: the client exists from the first door on."""

    def __init__(self, node):
        self._node = node
        self._client = None

    async def open(self, door):
        """Ask the building to open a door; returns whether it did."""
        if self._client is None:
            self._client = self._node.create_client(OpenDoor, DOOR_SERVICE)
        if not self._client.wait_for_service(timeout_sec=2.0):
            return False
        answer = await self._client.call_async(OpenDoor.Request(door=door))
        return answer.open
