// SPDX-License-Identifier: Apache-2.0
// Names by the rules of rcl.
#pragma once

#include <string>
#include <vector>

#include "rosward_double/core.hpp"

namespace rosward_double
{
std::string joined(const std::string & space, const std::string & name);
bool valid_node_name(const std::string & name);
bool valid_namespace(const std::string & space);
std::string expand(const std::string & given, const std::string & node, const std::string & space, bool service);
std::string remapped(
  const std::string & name, const std::vector<RemapRule> & rules, const std::string & node, const std::string & space, bool service);
// The value that a text in YAML says.
rclcpp::ParameterValue yaml_value(const std::string & text);
}  // namespace rosward_double
