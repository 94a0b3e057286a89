// SPDX-License-Identifier: Apache-2.0
// Clients of the parameter services of a node, and the handler of parameter events.
#pragma once

#include <future>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/node.hpp"

namespace rclcpp
{
class AsyncParametersClient
{
public:
  using SharedPtr = std::shared_ptr<AsyncParametersClient>;
  template<typename N>
  explicit AsyncParametersClient(N && node, const std::string & remote = "", const QoS & = QoS(10), CallbackGroup::SharedPtr = nullptr)
  : AsyncParametersClient(*rosward_double::core_of(node), remote)
  {
  }
  template<typename R = int64_t, typename P = std::milli>
  bool wait_for_service(std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
  {
    return true;
  }
  bool service_is_ready() const { return true; }
  std::shared_future<std::vector<Parameter>> get_parameters(
    const std::vector<std::string> & names, std::function<void(std::shared_future<std::vector<Parameter>>)> callback = nullptr);
  std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> set_parameters(
    const std::vector<Parameter> & parameters,
    std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>)> callback = nullptr);

  template<typename F>
  Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(F && callback)
  {
    return rosward_double::subscription<rcl_interfaces::msg::ParameterEvent>(*node_, "/parameter_events", std::forward<F>(callback));
  }

  template<typename N, typename F>
  static Subscription<rcl_interfaces::msg::ParameterEvent>::SharedPtr on_parameter_event(N && node, F && callback)
  {
    return rosward_double::subscription<rcl_interfaces::msg::ParameterEvent>(
      *rosward_double::core_of(node), "/parameter_events", std::forward<F>(callback));
  }

private:
  AsyncParametersClient(rosward_double::Core & node, const std::string & remote);
  std::shared_ptr<rosward_double::Core> node_;
};

class SyncParametersClient : public AsyncParametersClient
{
public:
  using SharedPtr = std::shared_ptr<SyncParametersClient>;
  using AsyncParametersClient::AsyncParametersClient;
  std::vector<Parameter> get_parameters(const std::vector<std::string> &) { return {}; }
  bool has_parameter(const std::string &) { return true; }
  template<typename T>
  T get_parameter(const std::string &, const T & alternative = T())
  {
    return alternative;
  }
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    return std::vector<rcl_interfaces::msg::SetParametersResult>(parameters.size());
  }
};

struct ParameterCallbackHandle
{
  using SharedPtr = std::shared_ptr<ParameterCallbackHandle>;
};
struct ParameterEventCallbackHandle
{
  using SharedPtr = std::shared_ptr<ParameterEventCallbackHandle>;
};

class ParameterEventHandler
{
public:
  using SharedPtr = std::shared_ptr<ParameterEventHandler>;
  template<typename N>
  explicit ParameterEventHandler(N && node, const QoS & = QoS(10)) : ParameterEventHandler(*rosward_double::core_of(node))
  {
  }
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string &, std::function<void(const Parameter &)>, const std::string & = "");
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(std::function<void(const rcl_interfaces::msg::ParameterEvent &)>);

private:
  explicit ParameterEventHandler(rosward_double::Core & node);
};
}  // namespace rclcpp
