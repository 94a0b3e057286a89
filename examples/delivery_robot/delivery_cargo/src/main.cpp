// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "delivery_cargo/compartment.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const auto compartment = std::make_shared<delivery_cargo::Compartment>();
  rclcpp::spin(compartment->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
