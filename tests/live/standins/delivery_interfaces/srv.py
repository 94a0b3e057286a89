# SPDX-License-Identifier: Apache-2.0
"""delivery_interfaces/srv."""
# mypy: ignore-errors

from borrowed import message
from geometry_msgs.msg import PoseStamped
from test_msgs.srv import Arrays, BasicTypes


class OpenDoor(BasicTypes):
    """The service of the doors."""

    Request = message(BasicTypes.Request, door=str)
    Response = message(BasicTypes.Response, open=bool, message=str)


class RequestDelivery(Arrays):
    """The service of the orders."""

    Request = message(Arrays.Request, item=str, destination=PoseStamped, doors=list)
    Response = message(Arrays.Response, accepted=bool, delivery_id=str, robot=str)
