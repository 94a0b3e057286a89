// SPDX-License-Identifier: Apache-2.0
// rosbag2: what is recorded goes to a file, what is played comes from one.

namespace rosbag2_cpp
{
class [[rosward::sink("file")]] Writer {};
class [[rosward::source("file"), rosward::changes]] Reader {};
namespace writers
{
class [[rosward::sink("file")]] SequentialWriter {};
}
namespace readers
{
class [[rosward::source("file"), rosward::changes]] SequentialReader {};
}
}
namespace rosbag2_transport
{
class [[rosward::sink("file")]] Recorder {};
class [[rosward::source("file")]] Player {};
}
