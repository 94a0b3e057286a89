// SPDX-License-Identifier: Apache-2.0
// With which options a node starts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
class InitOptions
{
public:
  bool shutdown_on_signal = true;
  InitOptions & auto_initialize_logging(bool) { return *this; }
  void set_domain_id(size_t) {}
};
enum class SignalHandlerOptions { All, SigInt, SigTerm, None };

class Context : public std::enable_shared_from_this<Context>
{
public:
  using SharedPtr = std::shared_ptr<Context>;
  virtual ~Context() = default;
  void init(int argc, char const * const * argv, const InitOptions & = InitOptions());
  bool is_valid() const;
  bool shutdown(const std::string &);
  template<typename F>
  F on_shutdown(F callback)
  {
    return callback;
  }
  template<typename F>
  void add_pre_shutdown_callback(F)
  {
  }
  template<typename F>
  void add_on_shutdown_callback(F)
  {
  }
};

class NodeOptions
{
public:
#define ROSWARD_DOUBLE_OPTION(TYPE, NAME, DEFAULT) \
private: \
  TYPE NAME ## _ = DEFAULT; \
 \
public: \
  const TYPE & NAME() const { return NAME ## _; } \
  NodeOptions & NAME(const TYPE & value) \
  { \
    NAME ## _ = value; \
    return *this; \
  }
  ROSWARD_DOUBLE_OPTION(std::vector<std::string>, arguments, {})
  ROSWARD_DOUBLE_OPTION(bool, use_global_arguments, true)
  ROSWARD_DOUBLE_OPTION(bool, enable_rosout, true)
  ROSWARD_DOUBLE_OPTION(bool, use_intra_process_comms, false)
  ROSWARD_DOUBLE_OPTION(bool, enable_topic_statistics, false)
  ROSWARD_DOUBLE_OPTION(bool, start_parameter_services, true)
  ROSWARD_DOUBLE_OPTION(bool, enable_logger_service, false)
  ROSWARD_DOUBLE_OPTION(bool, start_parameter_event_publisher, true)
  ROSWARD_DOUBLE_OPTION(bool, use_clock_thread, true)
  ROSWARD_DOUBLE_OPTION(bool, allow_undeclared_parameters, false)
  ROSWARD_DOUBLE_OPTION(bool, automatically_declare_parameters_from_overrides, false)
  ROSWARD_DOUBLE_OPTION(QoS, clock_qos, ClockQoS())
  ROSWARD_DOUBLE_OPTION(QoS, rosout_qos, RosoutQoS())
  ROSWARD_DOUBLE_OPTION(QoS, parameter_event_qos, ParameterEventsQoS())
#undef ROSWARD_DOUBLE_OPTION

  std::vector<Parameter> & parameter_overrides() { return overrides_; }
  const std::vector<Parameter> & parameter_overrides() const { return overrides_; }
  NodeOptions & parameter_overrides(const std::vector<Parameter> & values)
  {
    overrides_ = values;
    return *this;
  }
  template<typename T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }
  NodeOptions & context(std::shared_ptr<Context>) { return *this; }

private:
  std::vector<Parameter> overrides_;
};
}  // namespace rclcpp
