# SPDX-License-Identifier: Apache-2.0
"""launch.event.

Read from launch 3.7.0, with what humble had before it.
"""

class Event: ...
