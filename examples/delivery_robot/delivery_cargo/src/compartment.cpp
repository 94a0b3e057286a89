// SPDX-License-Identifier: Apache-2.0
#include "delivery_cargo/compartment.hpp"

#include <chrono>

namespace delivery_cargo
{

Compartment::Compartment(const rclcpp::NodeOptions & options)
: rclcpp_lifecycle::LifecycleNode("compartment", delivery_drivers::kRobot, options), heartbeat_(*this)
{
  declare_parameter("capacity", 20.0);
}

Compartment::CallbackReturn Compartment::on_configure(const rclcpp_lifecycle::State &)
{
  capacity_ = get_parameter("capacity").as_double();
  if (capacity_ <= 0.0) {
    RCLCPP_ERROR(get_logger(), "a compartment holds more than %.1f kg", capacity_);
    return CallbackReturn::FAILURE;
  }
  weight_ = create_publisher<std_msgs::msg::Float64>("cargo/weight", rclcpp::SensorDataQoS());
  full_ = create_publisher<std_msgs::msg::Bool>("cargo/full", rclcpp::QoS(1).transient_local());
  return CallbackReturn::SUCCESS;
}

Compartment::CallbackReturn Compartment::on_activate(const rclcpp_lifecycle::State & state)
{
  lock_ = create_service<SetBool>(
    "~/lock", [this](const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
      on_lock(*request, *response);
    });
  timer_ = create_wall_timer(std::chrono::seconds{1}, [this] { weigh(); });
  return LifecycleNode::on_activate(state);
}

Compartment::CallbackReturn Compartment::on_deactivate(const rclcpp_lifecycle::State & state)
{
  timer_.reset();
  lock_.reset();
  return LifecycleNode::on_deactivate(state);
}

Compartment::CallbackReturn Compartment::on_cleanup(const rclcpp_lifecycle::State &)
{
  weight_.reset();
  full_.reset();
  return CallbackReturn::SUCCESS;
}

void Compartment::on_lock(const SetBool::Request & request, SetBool::Response & response)
{
  locked_ = request.data;
  response.success = true;
  response.message = locked_ ? "locked" : "open";
}

void Compartment::weigh()
{
  std_msgs::msg::Float64 weight;
  weight.data = locked_ ? 7.5 : 0.0;
  weight_->publish(weight);

  std_msgs::msg::Bool full;
  full.data = weight.data >= capacity_;
  full_->publish(full);
}

}  // namespace delivery_cargo
