// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tf2_ros/buffer.h"

namespace tf2_ros
{
class TransformListener
{
public:
  using SharedPtr = std::shared_ptr<TransformListener>;
  // Without a node it makes one of its own.
  explicit TransformListener(Buffer &, bool = true)
  {
    rclcpp::NodeOptions options;
    options.start_parameter_services(false);
    options.start_parameter_event_publisher(false);
    node_ = std::make_shared<rclcpp::Node>("transform_listener_impl_0", options);
    listen(*node_->core());
  }
  template<typename NodeT, typename ... T>
  TransformListener(Buffer &, NodeT && node, const T & ...)
  {
    listen(*rosward_double::core_of(node));
  }

private:
  void listen(rosward_double::Core & node)
  {
    const auto ignore = [](std::shared_ptr<const tf2_msgs::msg::TFMessage>) {};
    tf_ = rosward_double::subscription<tf2_msgs::msg::TFMessage>(node, "/tf", ignore);
    tf_static_ = rosward_double::subscription<tf2_msgs::msg::TFMessage>(node, "/tf_static", ignore);
  }
  std::shared_ptr<rclcpp::Node> node_;
  std::shared_ptr<rosward_double::Entity> tf_, tf_static_;
};
}  // namespace tf2_ros
