# SPDX-License-Identifier: Apache-2.0
"""diagnostic_msgs/msg, as far as the example needs it."""
# mypy: ignore-errors

from borrowed import message
from std_msgs.msg import Header
from test_msgs.msg import Arrays, Strings

DiagnosticStatus = message(Strings, level=lambda: b"\0", name=str, message=str, hardware_id=str, values=list)
for _number, _name in enumerate(("OK", "WARN", "ERROR", "STALE")):
    setattr(DiagnosticStatus, _name, bytes([_number]))
DiagnosticArray = message(Arrays, header=Header, status=list)
