# SPDX-License-Identifier: Apache-2.0
"""ros2_numpy.registry.

Read from Box-Robotics/ros2_numpy (2020-07).
"""

from _rosward import message, reads_only


def converts_to_numpy(msgtype, plural=False):
    return lambda function: function


def converts_from_numpy(msgtype, plural=False):
    return lambda function: function


@reads_only
def numpify(msg, *args, **kwargs): ...


def msgify(msg_type, numpy_obj, *args, **kwargs):
    return message(msg_type, "made from an array")
