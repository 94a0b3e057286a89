// SPDX-License-Identifier: Apache-2.0
#ifndef DELIVERY_DRIVERS__LIDAR_DRIVER_HPP_
#define DELIVERY_DRIVERS__LIDAR_DRIVER_HPP_

#include <string>

#include "delivery_drivers/heartbeat.hpp"
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "std_srvs/srv/set_bool.hpp"

namespace delivery_drivers
{

/// One lidar of the robot, a component: a container holds as many as there are lidars.
class LidarDriver : public rclcpp::Node
{
public:
  explicit LidarDriver(const rclcpp::NodeOptions & options);

private:
  using SetBool = std_srvs::srv::SetBool;

  void on_motor(const SetBool::Request & request, SetBool::Response & response);
  void check(diagnostic_updater::DiagnosticStatusWrapper & status);
  void scan();

  const std::string place_;
  bool turning_{true};
  Heartbeat<rclcpp::Node> heartbeat_;
  diagnostic_updater::Updater updater_;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::Service<SetBool>::SharedPtr motor_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace delivery_drivers

#endif  // DELIVERY_DRIVERS__LIDAR_DRIVER_HPP_
