# SPDX-License-Identifier: Apache-2.0
"""What does an editor show of a ROS 2 system while its sources are being written? A server of the Language Server Protocol.

    editor  ──  protocol  ──  state, and what is asked of it  ──  workers  ──  worker (a process)  ──  session  ──  pipeline

`protocol` alone knows pygls. Everything that is asked is answered from the last views (`records.py`), which workers renew.
"""
