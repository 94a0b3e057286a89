// SPDX-License-Identifier: Apache-2.0
// Libraries that only compute, and what of the client library no header of the models declares.

namespace [[rosward::pure]] Eigen {}
namespace [[rosward::pure]] rclcpp {}
namespace [[rosward::pure]] angles {}
namespace [[rosward::pure]] tf2_geometry_msgs {}
namespace [[rosward::pure]] std_msgs {}
namespace boost
{
namespace [[rosward::pure]] algorithm {}
}
namespace [[rosward::pure]] fmt
{
[[rosward::sink("stdout")]] void print();
}
