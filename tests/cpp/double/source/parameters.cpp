// SPDX-License-Identifier: Apache-2.0
// The parameters of a node: declared, overridden, changed, asked.
#include "rclcpp/parameter.hpp"

#include "rosward_double/contents.hpp"
#include "rosward_double/core.hpp"

namespace rclcpp
{
using exceptions::InvalidParameterTypeException;
using rcl_interfaces::msg::SetParametersResult;

std::string to_string(ParameterType type)
{
  static const char * const names[] = {"not set", "bool", "integer", "double", "string", "byte_array", "bool_array", "integer_array", "double_array", "string_array"};
  return names[type];
}

void ParameterValue::wrong_type(ParameterType expected) const
{
  throw ParameterTypeException("expected [" + to_string(expected) + "] got [" + to_string(get_type()) + "]");
}

std::string to_string(const ParameterValue & value)
{
  switch (value.get_type()) {
    case PARAMETER_BOOL: return value.get<bool>() ? "true" : "false";
    case PARAMETER_INTEGER: return std::to_string(value.get<int64_t>());
    case PARAMETER_DOUBLE: return std::to_string(value.get<double>());
    case PARAMETER_STRING: return value.get<std::string>();
    default: return to_string(value.get_type());
  }
}

rcl_interfaces::msg::Parameter Parameter::to_parameter_msg() const
{
  rcl_interfaces::msg::Parameter message;
  message.name = name_;
  return message;
}
}  // namespace rclcpp

namespace rosward_double
{
using namespace rclcpp;

namespace
{
bool is_own(const std::string & name) { return name == "use_sim_time" || name == "start_type_description_service"; }

// What somebody sets a parameter to, where it is observed: a value of the same type.
ParameterValue arriving(const std::string & name, int turn, const ParameterValue & like)
{
  if (!observed() || is_own(name)) {
    return like;
  }
  Contents contents("parameter:" + name, turn);
  const auto filled = [&contents](auto value) {
      fill(value, contents);
      return ParameterValue(value);
    };
  switch (like.get_type()) {
    case PARAMETER_BOOL: return filled(false);
    case PARAMETER_INTEGER: return filled(int64_t());
    case PARAMETER_DOUBLE: return filled(0.0);
    case PARAMETER_STRING: return filled(std::string());
    case PARAMETER_INTEGER_ARRAY: return filled(std::vector<int64_t>());
    case PARAMETER_DOUBLE_ARRAY: return filled(std::vector<double>());
    case PARAMETER_STRING_ARRAY: return filled(std::vector<std::string>());
    default: return like;
  }
}
}  // namespace

const ParameterValue & Parameters::declare(
  Core & node, const std::string & name, ParameterType type, const ParameterValue & given,
  const rcl_interfaces::msg::ParameterDescriptor & descriptor, bool ignore_override)
{
  if (name.empty()) {
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  }
  if (declared.count(name)) {
    throw exceptions::ParameterAlreadyDeclaredException("parameter '" + name + "' has already been declared");
  }
  if (!descriptor.dynamic_typing && type == PARAMETER_NOT_SET) {
    throw exceptions::InvalidParameterTypeException("declaring parameter '" + name + "': no type");
  }
  const auto found = overrides.find(name);
  const ParameterValue value = found != overrides.end() && !ignore_override ? found->second : arriving(name, 0, given);
  if (!descriptor.dynamic_typing && value.get_type() != PARAMETER_NOT_SET && value.get_type() != type) {
    throw exceptions::InvalidParameterTypeException("parameter '" + name + "' has the wrong type");
  }
  if (value.get_type() != PARAMETER_NOT_SET) {
    const auto result = ask({Parameter(name, value)});
    if (!result.successful) {
      throw exceptions::InvalidParameterValueException("parameter '" + name + "' could not be set: " + result.reason);
    }
  }
  auto & kept = declared[name];
  kept = {value, descriptor};
  kept.descriptor.name = name;
  kept.descriptor.type = type;
  if (name == "use_sim_time" && value.get_type() == PARAMETER_BOOL && value.get<bool>()) {
    node.follow_clock();
  }
  return kept.value;
}

bool Parameters::get(const std::string & name, Parameter & found) const
{
  const auto at = declared.find(name);
  if (at == declared.end() || at->second.value.get_type() == PARAMETER_NOT_SET) {
    return false;
  }
  found = Parameter(name, at->second.value);
  return true;
}

Parameter Parameters::get(const std::string & name) const
{
  const auto at = declared.find(name);
  if (at == declared.end()) {
    if (allow_undeclared) {
      return Parameter(name);
    }
    throw exceptions::ParameterNotDeclaredException(name);
  }
  if (at->second.value.get_type() == PARAMETER_NOT_SET && !at->second.descriptor.dynamic_typing) {
    throw exceptions::ParameterUninitializedException(name);
  }
  return Parameter(name, at->second.value);
}

SetParametersResult Parameters::ask(const std::vector<Parameter> & changed) const
{
  SetParametersResult result;
  result.successful = true;
  const auto handles = on_set;
  for (auto handle = handles.rbegin(); handle != handles.rend(); ++handle) {  // the last that was added is asked first
    if (const auto held = handle->lock()) {
      result = held->callback(changed);
      if (!result.successful) {
        break;
      }
    }
  }
  return result;
}

SetParametersResult Parameters::apply(Core & node, const std::vector<Parameter> & changed)
{
  for (const auto & each : changed) {
    const auto at = declared.find(each.get_name());
    if (at == declared.end()) {
      if (!allow_undeclared) {
        throw exceptions::ParameterNotDeclaredException("parameter '" + each.get_name() + "' cannot be set because it was not declared");
      }
      declared[each.get_name()];
      continue;
    }
    const auto & descriptor = at->second.descriptor;
    if (descriptor.read_only || (!descriptor.dynamic_typing && each.get_type() != static_cast<ParameterType>(descriptor.type))) {
      SetParametersResult result;
      result.successful = false;
      result.reason = descriptor.read_only ? "read-only" : "wrong type";
      return result;
    }
  }
  const auto result = ask(changed);
  if (result.successful) {
    for (const auto & each : changed) {
      declared[each.get_name()].value = each.get_parameter_value();
      if (each.get_name() == "use_sim_time" && each.as_bool()) {
        node.follow_clock();
      }
    }
    const auto handles = post_set;
    for (const auto & handle : handles) {
      if (const auto held = handle.lock()) {
        held->callback(changed);
      }
    }
  }
  return result;
}

void Parameters::change(Core & node, int turn)
{
  std::vector<Parameter> changed;
  for (const auto & [name, kept] : declared) {
    if (!is_own(name) && !kept.descriptor.read_only) {
      changed.emplace_back(name, arriving(name, turn, kept.value));
    }
  }
  for (const auto & each : changed) {
    set(node, {each}, true);
  }
}

std::vector<SetParametersResult> Parameters::set(Core & node, std::vector<Parameter> changed, bool together)
{
  const auto handles = pre_set;
  std::vector<SetParametersResult> results;
  if (!together) {
    for (const auto & each : changed) {
      results.push_back(set(node, {each}, true).at(0));
    }
    return results;
  }
  for (const auto & handle : handles) {
    if (const auto held = handle.lock()) {
      held->callback(changed);
    }
  }
  results.push_back(apply(node, changed));
  return results;
}
}  // namespace rosward_double
