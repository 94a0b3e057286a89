// SPDX-License-Identifier: Apache-2.0
// Names by the rules of rcl: they are checked, expanded, remapped.
#include "rosward_double/names.hpp"

#include <cctype>

#include "rclcpp/exceptions.hpp"

namespace rosward_double
{
namespace
{
bool word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

[[noreturn]] void invalid(const std::string & name, bool service)
{
  if (service) {
    throw rclcpp::exceptions::InvalidServiceNameError("Invalid service name: " + name);
  }
  throw rclcpp::exceptions::InvalidTopicNameError("Invalid topic name: " + name);
}

bool valid_start(const std::string & name)  // before it is expanded
{
  if (name.empty() || name.back() == '/' || std::isdigit(static_cast<unsigned char>(name[0]))) {
    return false;
  }
  bool braces = false;
  for (size_t i = 0; i < name.size(); i++) {
    const char c = name[i];
    if (c == '{' || c == '}') {
      if (braces == (c == '{')) {
        return false;
      }
      braces = c == '{';
    } else if (c == '~' ? i != 0 : !(word(c) || (c == '/' && !braces))) {
      return false;
    } else if (c == '/' && i + 1 < name.size() && std::isdigit(static_cast<unsigned char>(name[i + 1]))) {
      return false;
    }
  }
  return !braces;
}

bool valid_full(const std::string & name)
{
  if (name.size() < 2 || name[0] != '/' || name.back() == '/') {
    return false;
  }
  for (size_t i = 0; i < name.size(); i++) {
    if (name[i] == '/') {
      if (name[i + 1] == '/' || std::isdigit(static_cast<unsigned char>(name[i + 1]))) {
        return false;
      }
    } else if (!word(name[i])) {
      return false;
    }
  }
  return true;
}
}  // namespace

std::string joined(const std::string & space, const std::string & name) { return (space == "/" ? "" : space) + "/" + name; }

bool valid_node_name(const std::string & name)
{
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) {
    return false;
  }
  for (const char c : name) {
    if (!word(c)) {
      return false;
    }
  }
  return true;
}

bool valid_namespace(const std::string & space) { return space == "/" || valid_full(space); }

std::string expand(const std::string & given, const std::string & node, const std::string & space, bool service)
{
  if (!valid_start(given)) {
    invalid(given, service);
  }
  std::string name = given;
  for (size_t open = name.find('{'); open != std::string::npos; open = name.find('{')) {
    const size_t close = name.find('}', open);
    const std::string key = name.substr(open + 1, close - open - 1);
    if (key != "node" && key != "ns" && key != "namespace") {
      throw rclcpp::exceptions::RCLError("unknown substitution: " + key);
    }
    name.replace(open, close - open + 1, key == "node" ? node : space);
  }
  if (name[0] == '~') {
    name = joined(space, node) + name.substr(1);
  } else if (name[0] != '/') {
    name = joined(space, name);
  }
  if (!valid_full(name)) {
    invalid(given, service);
  }
  return name;
}

std::string remapped(
  const std::string & name, const std::vector<RemapRule> & rules, const std::string & node, const std::string & space, bool service)
{
  for (const auto & rule : rules) {
    if (rule.from.substr(0, 2) == "__" || (!rule.node.empty() && rule.node != node)) {
      continue;
    }
    if (!rule.scope.empty() && rule.scope != (service ? "rosservice" : "rostopic")) {
      continue;
    }
    if (expand(rule.from, node, space, service) == name) {
      return expand(rule.to, node, space, service);
    }
  }
  return name;
}
}  // namespace rosward_double
