// SPDX-License-Identifier: Apache-2.0
// Transforms: all of them are there, and none moves anything.
#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.h"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_msgs/srv/frame_graph.hpp"

namespace tf2
{
using TimePoint = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;
using Duration = std::chrono::nanoseconds;
inline const TimePoint TimePointZero{};
inline Duration durationFromSec(double seconds) { return Duration(static_cast<int64_t>(seconds * 1e9)); }
}  // namespace tf2

namespace tf2_ros
{
class Buffer
{
public:
  using SharedPtr = std::shared_ptr<Buffer>;
  explicit Buffer(rclcpp::Clock::SharedPtr, tf2::Duration = {}) {}
  template<typename NodeT>
  Buffer(rclcpp::Clock::SharedPtr, tf2::Duration, NodeT && node, const rclcpp::QoS & = rclcpp::QoS(10))
  {
    const auto core = rosward_double::core_of(node);
    service_ = rosward_double::service<tf2_msgs::srv::FrameGraph>(
      *core, "tf2_frames", [](std::shared_ptr<tf2_msgs::srv::FrameGraph::Request>, std::shared_ptr<tf2_msgs::srv::FrameGraph::Response>) {});
  }
  template<typename ... T>
  geometry_msgs::msg::TransformStamped lookupTransform(const std::string &, const std::string &, const T & ...) const
  {
    return geometry_msgs::msg::TransformStamped();
  }
  template<typename ... T>
  bool canTransform(const std::string &, const std::string &, const T & ...) const
  {
    return true;
  }
  template<typename M, typename ... T>
  M transform(const M & given, const std::string &, const T & ...) const
  {
    return given;
  }
  template<typename ... T>
  bool setTransform(const T & ...)
  {
    return true;
  }
  template<typename T>
  void setCreateTimerInterface(T)
  {
  }
  void setUsingDedicatedThread(bool) {}

private:
  std::shared_ptr<rosward_double::Entity> service_;
};

class CreateTimerROS
{
public:
  template<typename ... T>
  explicit CreateTimerROS(const T & ...)
  {
  }
};
}  // namespace tf2_ros
