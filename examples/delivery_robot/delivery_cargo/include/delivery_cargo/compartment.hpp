// SPDX-License-Identifier: Apache-2.0
#ifndef DELIVERY_CARGO__COMPARTMENT_HPP_
#define DELIVERY_CARGO__COMPARTMENT_HPP_

#include <memory>

#include "delivery_drivers/heartbeat.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_srvs/srv/set_bool.hpp"

namespace delivery_cargo
{

/// Where the goods are: a lock and a scale, which a manager of lifecycle nodes brings up.
class Compartment : public rclcpp_lifecycle::LifecycleNode
{
public:
  using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

  explicit Compartment(const rclcpp::NodeOptions & options = rclcpp::NodeOptions());

  CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State & state) override;

private:
  using SetBool = std_srvs::srv::SetBool;

  void on_lock(const SetBool::Request & request, SetBool::Response & response);
  void weigh();

  bool locked_{true};
  double capacity_{0.0};
  delivery_drivers::Heartbeat<rclcpp_lifecycle::LifecycleNode> heartbeat_;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Float64>::SharedPtr weight_;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Bool>::SharedPtr full_;
  rclcpp::Service<SetBool>::SharedPtr lock_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace delivery_cargo

#endif  // DELIVERY_CARGO__COMPARTMENT_HPP_
