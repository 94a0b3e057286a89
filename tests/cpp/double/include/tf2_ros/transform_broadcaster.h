// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tf2_ros/buffer.h"

namespace tf2_ros
{
class Broadcaster
{
public:
  void sendTransform(const geometry_msgs::msg::TransformStamped &) {}
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> &) {}

protected:
  Broadcaster(rosward_double::Core & node, const char * topic) : publisher_(rosward_double::publisher<tf2_msgs::msg::TFMessage>(node, topic)) {}

private:
  std::shared_ptr<rosward_double::Entity> publisher_;
};
class TransformBroadcaster : public Broadcaster
{
public:
  template<typename NodeT>
  explicit TransformBroadcaster(NodeT && node, const rclcpp::QoS & = rclcpp::QoS(10)) : Broadcaster(*rosward_double::core_of(node), "/tf")
  {
  }
};
class StaticTransformBroadcaster : public Broadcaster
{
public:
  template<typename NodeT>
  explicit StaticTransformBroadcaster(NodeT && node, const rclcpp::QoS & = rclcpp::QoS(10))
  : Broadcaster(*rosward_double::core_of(node), "/tf_static")
  {
  }
};
}  // namespace tf2_ros
