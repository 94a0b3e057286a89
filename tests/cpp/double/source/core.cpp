// SPDX-License-Identifier: Apache-2.0
// How a node begins, and what is said of it.
#include "rosward_double/core.hpp"

#include <cstdio>
#include <iostream>

#include "rclcpp/node_options.hpp"
#include "rosward_double/names.hpp"

namespace rosward_double
{
void log(const std::string & line)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  std::cout.flush();
  std::printf("\n@double %s\n", line.c_str());
  std::fflush(stdout);
}

Core::Core(const std::string & name, const std::string & space, const rclcpp::NodeOptions & options)
: parameters(std::make_unique<Parameters>()), name_(name), space_(space)
{
  const Arguments own = read_arguments(options.arguments());
  const Arguments none;
  const Arguments & global = options.use_global_arguments() ? global_arguments() : none;
  remaps_ = own.remaps;
  remaps_.insert(remaps_.end(), global.remaps.begin(), global.remaps.end());
  if (space_.empty() || space_[0] != '/') {
    space_ = "/" + space_;
  }
  if (!valid_node_name(name_)) {
    throw rclcpp::exceptions::InvalidNodeNameError("Invalid node name: " + name);
  }
  if (!valid_namespace(space_)) {
    throw rclcpp::exceptions::InvalidNamespaceError("Invalid namespace: " + space);
  }
  for (const auto & [key, target] : {std::pair("__ns", &space_), std::pair("__node", &name_)}) {
    for (const auto & rule : remaps_) {
      if (rule.from == key && (rule.node.empty() || rule.node == name)) {
        *target = rule.to;
        break;
      }
    }
  }
  full_name_ = joined(space_, name_);

  parameters->allow_undeclared = options.allow_undeclared_parameters();
  for (const auto * rules : {&global.parameters, &own.parameters}) {
    for (const auto & rule : *rules) {
      if (rule.node.empty() || rule.node == name_ || rule.node == full_name_ || rule.node == "/**") {
        parameters->overrides[rule.name] = yaml_value(rule.value);
      }
    }
  }
  for (const auto & each : options.parameter_overrides()) {
    parameters->overrides[each.get_name()] = each.get_parameter_value();
  }

  log("node " + full_name_);
  if (options.enable_rosout()) {
    system("pub", "/rosout", "rcl_interfaces/msg/Log");
  }
  if (options.start_parameter_services()) {
    for (const auto & [service, type] : std::map<std::string, const char *>{
        {"describe_parameters", "DescribeParameters"}, {"get_parameter_types", "GetParameterTypes"}, {"get_parameters", "GetParameters"},
        {"list_parameters", "ListParameters"}, {"set_parameters", "SetParameters"}, {"set_parameters_atomically", "SetParametersAtomically"}}) {
      system("ss", full_name_ + "/" + service, (std::string("rcl_interfaces/srv/") + type).c_str());
    }
  }
  if (options.start_parameter_event_publisher()) {
    system("pub", "/parameter_events", "rcl_interfaces/msg/ParameterEvent");
  }
  system("sub", "/parameter_events", "rcl_interfaces/msg/ParameterEvent");
  statistics = options.enable_topic_statistics();
  if (statistics) {
    system("pub", "/statistics", "statistics_msgs/msg/MetricsMessage");
  }
  if (options.enable_logger_service()) {
    system("ss", full_name_ + "/get_logger_levels", "rcl_interfaces/srv/GetLoggerLevels");
    system("ss", full_name_ + "/set_logger_levels", "rcl_interfaces/srv/SetLoggerLevels");
  }
}

Core::~Core() = default;

std::string Core::resolve(const std::string & name, bool service, bool remap) const
{
  const std::string full = expand(name, name_, space_, service);
  return remap ? remapped(full, remaps_, name_, space_, service) : full;
}

std::string Core::create(const char * kind, const std::string & name, const std::string & type)
{
  const std::string full = resolve(name, std::string(kind) == "ss" || std::string(kind) == "sc");
  log(std::string(kind) + " " + full_name_ + " " + full + " " + type);
  return full;
}

void Core::system(const char * kind, const std::string & full_name, const char * type)
{
  log(std::string(kind) + " " + full_name_ + " " + full_name + " " + type + " system");
}

void Core::own(const std::shared_ptr<Entity> & entity)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  entities_.push_back(entity);
}

void Core::follow_clock()
{
  if (!clock_) {
    clock_ = true;
    system("sub", "/clock", "rosgraph_msgs/msg/Clock");
  }
}

bool Core::serve()
{
  std::vector<std::weak_ptr<Entity>> now;
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    now = entities_;
  }
  bool called = false;
  for (const auto & each : now) {
    if (const auto entity = each.lock()) {
      called = entity->serve() || called;
    }
  }
  if (observed() && called) {
    parameters->change(*this, ++rounds_);
  }
  return called;
}
}  // namespace rosward_double
