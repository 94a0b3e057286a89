// SPDX-License-Identifier: Apache-2.0
#ifndef DELIVERY_DRIVERS__HEARTBEAT_HPP_
#define DELIVERY_DRIVERS__HEARTBEAT_HPP_

#include <chrono>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/header.hpp"

namespace delivery_drivers
{

/// The namespace of the robot where nobody gives it another one.
inline constexpr char kRobot[] = "porter";

/// Tells the monitor twice a second that a node is alive, whatever kind of node it is.
template<typename NodeT>
class Heartbeat
{
public:
  explicit Heartbeat(NodeT & node)
  : clock_(node.get_clock()),
    name_(node.get_fully_qualified_name()),
    publisher_(rclcpp::create_publisher<std_msgs::msg::Header>(node, "/" + std::string{kRobot} + "/heartbeat", 10)),
    timer_(node.create_wall_timer(std::chrono::milliseconds{500}, [this] { beat(); }))
  {
  }

private:
  void beat()
  {
    std_msgs::msg::Header header;
    header.stamp = clock_->now();
    header.frame_id = name_;
    publisher_->publish(header);
  }

  rclcpp::Clock::SharedPtr clock_;
  std::string name_;
  rclcpp::Publisher<std_msgs::msg::Header>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace delivery_drivers

#endif  // DELIVERY_DRIVERS__HEARTBEAT_HPP_
