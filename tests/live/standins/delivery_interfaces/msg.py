# SPDX-License-Identifier: Apache-2.0
"""delivery_interfaces/msg."""
# mypy: ignore-errors

from borrowed import message
from builtin_interfaces.msg import Time
from test_msgs.msg import BasicTypes

DeliveryStatus = message(BasicTypes, stamp=Time, delivery_id=str, robot=str, state=int)
for _number, _name in enumerate(("ACCEPTED", "UNDER_WAY", "DELIVERED", "FAILED")):
    setattr(DeliveryStatus, _name, _number)
