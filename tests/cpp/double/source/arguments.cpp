// SPDX-License-Identifier: Apache-2.0
// What a command line says: `--ros-args -r from:=to -p name:=value -- others`.
#include "rclcpp/exceptions.hpp"
#include "rclcpp/parameter.hpp"
#include "rosward_double/names.hpp"

namespace rosward_double
{
namespace
{
// Splits `node:rest` where there is such a prefix.
std::string take_node(std::string & rule, size_t end)
{
  const size_t colon = rule.find(':');
  if (colon == std::string::npos || colon >= end || rule.compare(colon, 3, "://") == 0) {
    return "";
  }
  const std::string node = rule.substr(0, colon);
  rule = rule.substr(colon + 1);
  return node;
}

size_t assignment(const std::string & rule)
{
  const size_t found = rule.find(":=");
  if (found == std::string::npos) {
    throw rclcpp::exceptions::RCLError("no rule: " + rule);
  }
  return found;
}

RemapRule remap_rule(std::string text)
{
  RemapRule rule;
  rule.node = take_node(text, assignment(text));
  const size_t scope = text.find("://");
  if (scope != std::string::npos) {
    rule.scope = text.substr(0, scope);
    text = text.substr(scope + 3);
  }
  const size_t at = assignment(text);
  rule.from = text.substr(0, at);
  rule.to = text.substr(at + 2);
  if (rule.from == "__name") {
    rule.from = "__node";
  }
  return rule;
}

ParameterRule parameter_rule(std::string text)
{
  ParameterRule rule;
  rule.node = take_node(text, assignment(text));
  const size_t at = assignment(text);
  rule.name = text.substr(0, at);
  rule.value = text.substr(at + 2);
  return rule;
}
}  // namespace

Arguments read_arguments(const std::vector<std::string> & words)
{
  Arguments read;
  bool ros = false;
  for (size_t i = 0; i < words.size(); i++) {
    const auto & word = words[i];
    if (word == "--ros-args") {
      ros = true;
    } else if (!ros) {
      read.others.push_back(word);
    } else if (word == "--") {
      ros = false;
    } else if (word == "-r" || word == "--remap") {
      read.remaps.push_back(remap_rule(words.at(++i)));
    } else if (word == "-p" || word == "--param") {
      read.parameters.push_back(parameter_rule(words.at(++i)));
    } else if (word == "--params-file" || word == "-e" || word == "--enclave" || word == "--log-level" || word == "--log-config-file") {
      i++;
    } else if (word.substr(0, 10) != "--disable-" && word.substr(0, 9) != "--enable-") {
      throw rclcpp::exceptions::UnknownROSArgsError("found invalid ROS arguments: " + word);
    }
  }
  return read;
}

rclcpp::ParameterValue yaml_value(const std::string & text)
{
  using rclcpp::ParameterValue;
  if (text.size() > 1 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0]) {
    return ParameterValue(text.substr(1, text.size() - 2));
  }
  if (text.size() > 1 && text[0] == '[' && text.back() == ']') {
    std::vector<ParameterValue> items;
    for (size_t at = 1; at < text.size();) {
      const size_t end = text.find_first_of(",]", at);
      const size_t first = text.find_first_not_of(' ', at);
      if (first < end) {
        items.push_back(yaml_value(text.substr(first, text.find_last_not_of(' ', end - 1) + 1 - first)));
      }
      at = end + 1;
    }
    const auto all = [&items](auto example) {
        std::vector<decltype(example)> found;
        for (const auto & item : items) {
          found.push_back(item.get<decltype(example)>());
        }
        return ParameterValue(found);
      };
    switch (items.empty() ? rclcpp::PARAMETER_STRING : items[0].get_type()) {
      case rclcpp::PARAMETER_BOOL: return all(false);
      case rclcpp::PARAMETER_INTEGER: return all(int64_t());
      case rclcpp::PARAMETER_DOUBLE: return all(0.0);
      default: return all(std::string());
    }
  }
  if (text == "true" || text == "false") {
    return ParameterValue(text == "true");
  }
  try {
    size_t used = 0;
    const long long whole = std::stoll(text, &used, 10);
    if (used == text.size()) {
      return ParameterValue(static_cast<int64_t>(whole));
    }
    const double real = std::stod(text, &used);
    if (used == text.size()) {
      return ParameterValue(real);
    }
  } catch (const std::logic_error &) {
  }
  return ParameterValue(text);
}
}  // namespace rosward_double
