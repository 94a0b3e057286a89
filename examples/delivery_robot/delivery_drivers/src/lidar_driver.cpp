// SPDX-License-Identifier: Apache-2.0
#include "delivery_drivers/lidar_driver.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "diagnostic_msgs/msg/diagnostic_status.hpp"

namespace delivery_drivers
{

namespace
{

constexpr std::size_t kRays = 360;

/// The topic of a sensor, relative to the namespace of the robot.
std::string sensor_topic(const std::string & place, const std::string & what)
{
  return "sensors/" + place + "/" + what;
}

}  // namespace

LidarDriver::LidarDriver(const rclcpp::NodeOptions & options)
: rclcpp::Node("lidar", kRobot, options),
  place_(declare_parameter<std::string>("place", "front")),
  heartbeat_(*this),
  updater_(this)
{
  scans_ = create_publisher<sensor_msgs::msg::LaserScan>(sensor_topic(place_, "scan"), rclcpp::SensorDataQoS());
  motor_ = create_service<SetBool>(
    "~/motor", [this](const SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
      on_motor(*request, *response);
    });

  updater_.setHardwareID("lidar " + place_);
  updater_.add("lidar status", this, &LidarDriver::check);

  const auto rate = declare_parameter<double>("rate", 10.0);
  timer_ = create_wall_timer(std::chrono::duration<double>{1.0 / rate}, [this] { scan(); });
}

void LidarDriver::on_motor(const SetBool::Request & request, SetBool::Response & response)
{
  turning_ = request.data;
  RCLCPP_INFO(get_logger(), "the lidar at the %s %s", place_.c_str(), turning_ ? "turns" : "stands");
  response.success = true;
}

void LidarDriver::check(diagnostic_updater::DiagnosticStatusWrapper & status)
{
  using diagnostic_msgs::msg::DiagnosticStatus;
  if (turning_) {
    status.summary(DiagnosticStatus::OK, "turning");
  } else {
    status.summary(DiagnosticStatus::WARN, "motor is switched off");
  }
}

void LidarDriver::scan()
{
  if (!turning_) {
    return;
  }
  auto scan = std::make_unique<sensor_msgs::msg::LaserScan>();
  scan->header.stamp = now();
  scan->header.frame_id = "lidar_" + place_;
  scan->angle_increment = static_cast<float>(2.0 * M_PI / kRays);
  scan->range_max = 12.0F;
  scan->ranges.assign(kRays, 4.0F);
  scans_->publish(std::move(scan));
}

}  // namespace delivery_drivers

#include "rclcpp_components/register_node_macro.hpp"
RCLCPP_COMPONENTS_REGISTER_NODE(delivery_drivers::LidarDriver)
