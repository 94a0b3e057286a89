// SPDX-License-Identifier: Apache-2.0
// Components: where a program has no `main`, one of each is made and all are spun.
#pragma once

#include "rclcpp/rclcpp.hpp"

#define ROSWARD_DOUBLE_JOIN_(a, b) a ## b
#define ROSWARD_DOUBLE_JOIN(a, b) ROSWARD_DOUBLE_JOIN_(a, b)
#define RCLCPP_COMPONENTS_REGISTER_NODE(CLASS) \
  static const int ROSWARD_DOUBLE_JOIN(rosward_double_component_, __COUNTER__) = \
    rosward_double::register_component(#CLASS, [](const rclcpp::NodeOptions & options) -> std::shared_ptr<void> { \
      auto made = std::make_shared<CLASS>(options); \
      rosward_double::component(rosward_double::core_of(made)); \
      return made; \
    });
