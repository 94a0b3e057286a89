# SPDX-License-Identifier: Apache-2.0
"""C++: the models in code, and functions of libraries, that store, only look, or only compute."""

from __future__ import annotations

from typing import Final

from rosward.flow.marked import Effect

STORES: Final = frozenset(
    [
        "push_back",
        "push",
        "emplace_back",
        "push_front",
        "emplace_front",
        "make_shared",
        "make_unique",
        "allocate_shared",
        "make_pair",
        "make_tuple",
        "forward_as_tuple",
        "tie",
        "bind",
        "insert_or_assign",
        "make_optional",
    ]
)
"""What they make, or write to, holds what they are given as it is."""

READS: Final = frozenset(
    [
        "size",
        "empty",
        "length",
        "begin",
        "end",
        "cbegin",
        "cend",
        "rbegin",
        "rend",
        "crbegin",
        "crend",
        "at",
        "operator[]",
        "front",
        "back",
        "top",
        "get",
        "lock",
        "reset",
        "release",
        "move",
        "forward",
        "ref",
        "cref",
        "as_const",
        "c_str",
        "data",
        "find",
        "count",
        "contains",
        "has_value",
        "value",
        "second",
        "first",
        "clear",
        "reserve",
        "static_pointer_cast",
        "dynamic_pointer_cast",
        "const_pointer_cast",
        "addressof",
        "pop_back",
        "pop_front",
        "pop",
        "use_count",
    ]
)
"""What they give depends on what they are called on and on the key, not on all that it leads to."""

SIZES: Final = frozenset(["size", "empty", "length", "ssize"])
"""What they give depends on how much there is."""

HOLDS: Final = ("rclcpp.Time", "rclcpp.Duration", "rclcpp.operator", "tf2.", "tf2_ros.fromMsg", "tf2_ros.toMsg")
"""How the names of functions of models begin that make what they give, and what they are called on, of what they get."""

LOGS: Final = ("RCLCPP_", "RCUTILS_LOG_")

SAFE: Final = STORES | frozenset(
    [
        "size",
        "empty",
        "length",
        "begin",
        "end",
        "cbegin",
        "cend",
        "front",
        "back",
        "c_str",
        "data",
        "move",
        "forward",
        "ref",
        "get",
        "reset",
        "clear",
        "reserve",
        "find",
        "count",
        "static_pointer_cast",
        "dynamic_pointer_cast",
    ]
)
"""They throw nothing because of what they are given."""

PURE: Final = (
    "std.", "tf2.", "tf2_geometry_msgs.", "angles.", "Eigen.", "fmt.", "std_msgs.", "rclcpp.", "boost.algorithm.",
)  # fmt: skip
"""How the names of functions begin that change nothing but what they are called on."""


def is_safe(name: str) -> bool:
    """Whether a model in code surely throws nothing."""
    return name.startswith((*LOGS, "rosward.")) or name.rpartition(".")[2] in SAFE


FUNCTIONS: Final = (
    Effect("std.printf std.puts std.putchar fmt.print", sink="stdout"),
    Effect("std.fprintf std.fputs std.fwrite fwrite std.remove std.rename std.filesystem.* cv.imwrite", sink="file"),
    Effect("std.fread fread std.fgets fgets cv.imread YAML.LoadFile", source="file"),
    Effect("send sendto sendmsg sendall", sink="network"),
    Effect("recv recvfrom recvmsg", source="network"),
    Effect("std.system std.popen popen system execv execvp std.execl std.execlp", sink="process"),
    Effect("std.system std.popen popen system fgets", source="process"),
    Effect("write ioctl tcsetattr digitalWrite softPwmWrite gpioWrite", sink="device"),
    Effect("read digitalRead gpioRead", source="device"),
    Effect(
        "rclcpp.Clock.now rclcpp.AnyNode.now rclcpp.Node.now std.time std.clock std.chrono.steady_clock.now "
        "std.chrono.system_clock.now std.chrono.high_resolution_clock.now clock_gettime gettimeofday",
        source="clock",
    ),
    Effect(
        "std.rand std.random std.random.int std.random.float std.random.int.operator() std.random.float.operator() "
        "std.random_device.new rand drand48",
        source="random",
    ),
    Effect("std.getenv std.secure_getenv", source="env"),
    Effect("std.getline std.cin.get std.getchar getchar", source="stdin"),
    Effect(
        "tf2_ros.BufferInterface.lookupTransform tf2_ros.BufferInterface.canTransform tf2_ros.BufferInterface.transform "
        "tf2_ros.Buffer.lookupTransform tf2_ros.Buffer.transform tf2_ros.Buffer.canTransform",
        source="tf",
    ),
    Effect("tf2_ros.TransformBroadcaster.sendTransform tf2_ros.StaticTransformBroadcaster.sendTransform", sink="tf"),
)
