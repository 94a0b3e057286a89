// SPDX-License-Identifier: Apache-2.0
// rclcpp: parameters of other nodes. Six clients under the name of the remote node; a subscription to /parameter_events.
//
// Read from rclcpp, branches humble, jazzy and rolling (parameter_client.hpp, parameter_event_handler.hpp, parameter_events_filter.hpp).

namespace rclcpp
{
class AsyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AsyncParametersClient)

  template<typename NodeT, typename QosT = QoS>
  [[rosward::creator]] explicit AsyncParametersClient(
    NodeT node, const std::string & remote_node_name = "", const QosT & qos_profile = ParametersQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    _connect(node, remote_node_name, qos_profile);
  }
  template<typename QosT = QoS>
  AsyncParametersClient(
    AnyNode::SharedPtr node_base, AnyNode::SharedPtr node_topics, AnyNode::SharedPtr node_graph,
    AnyNode::SharedPtr node_services, const std::string & remote_node_name = "", const QosT & qos_profile = ParametersQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    _connect(node_base, remote_node_name, qos_profile);
  }
  template<typename NodeT, typename QosT>
  void _connect(NodeT node, const std::string & remote_node_name, const QosT & qos)
  {
    _node = rosward::interface_of(node);
    const std::string remote = remote_node_name.empty() ? rosward::node_fqn(_node) : remote_node_name;
    rosward::create(
      "service_client", _node, remote + "/get_parameters", rosward::type<rcl_interfaces::srv::GetParameters>(), qos);
    rosward::create(
      "service_client", _node, remote + "/get_parameter_types", rosward::type<rcl_interfaces::srv::GetParameterTypes>(), qos);
    rosward::create(
      "service_client", _node, remote + "/set_parameters", rosward::type<rcl_interfaces::srv::SetParameters>(), qos);
    rosward::create(
      "service_client", _node, remote + "/set_parameters_atomically",
      rosward::type<rcl_interfaces::srv::SetParametersAtomically>(), qos);
    rosward::create(
      "service_client", _node, remote + "/list_parameters", rosward::type<rcl_interfaces::srv::ListParameters>(), qos);
    rosward::create(
      "service_client", _node, remote + "/describe_parameters", rosward::type<rcl_interfaces::srv::DescribeParameters>(), qos);
  }

  template<typename... ArgsT>
  auto get_parameters(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<std::vector<Parameter>>(detail::remote_parameters(names)), callback...);
  }
  template<typename... ArgsT>
  auto describe_parameters(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(rosward::unknown("message", "descriptors of parameters")), callback...);
  }
  template<typename... ArgsT>
  auto get_parameter_types(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(rosward::unknown("message", "types of parameters")), callback...);
  }
  template<typename... ArgsT>
  auto set_parameters(const std::vector<Parameter> & parameters, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(rosward::unknown("message", "results of set_parameters")), callback...);
  }
  template<typename... ArgsT>
  auto set_parameters_atomically(const std::vector<Parameter> & parameters, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(rosward::message<rcl_interfaces::msg::SetParametersResult>()), callback...);
  }
  auto delete_parameters(const std::vector<std::string> & parameters_names)
  {
    return detail::Future<rosward::value>(rosward::unknown("message", "results of set_parameters"));
  }
  template<typename SourceT>
  auto load_parameters(const SourceT & source)
  {
    return detail::Future<rosward::value>(rosward::unknown("message", "results of set_parameters"));
  }
  template<typename... ArgsT>
  auto list_parameters(const std::vector<std::string> & prefixes, uint64_t depth, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(rosward::message<rcl_interfaces::msg::ListParametersResult>()), callback...);
  }
  template<typename FutureT, typename... ArgsT>
  FutureT _answer(const FutureT & future, const ArgsT & ... callback)
  {
    (rosward::schedule(callback, "response", future), ...);
    return future;
  }

  template<typename CallbackT>
  auto on_parameter_event(CallbackT && callback) {return on_parameter_event(_node, callback);}
  template<typename NodeT, typename CallbackT>
  static auto on_parameter_event(NodeT && node, CallbackT && callback)
  {
    return rclcpp::create_subscription<rcl_interfaces::msg::ParameterEvent>(
      node, "/parameter_events", ParameterEventsQoS(), callback);
  }
  bool service_is_ready() const {return rosward::unknown("live", "whether a service is there", "bool");}
  template<typename TimeoutT = int>
  bool wait_for_service(const TimeoutT & timeout = -1)
  {
    return rosward::unknown("live", "whether a service is there", "bool");
  }

  AnyNode * _node = nullptr;
};

namespace detail
{
std::vector<Parameter> remote_parameters(const std::vector<std::string> & names)
{
  std::vector<Parameter> parameters;
  for (const auto & name : names) {
    parameters.push_back(Parameter(name, rosward::unknown("message", "value of a parameter of another node")));
  }
  return parameters;
}
}  // namespace detail

class SyncParametersClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SyncParametersClient)

  template<typename NodeT, typename QosT = QoS>
  [[rosward::creator]] explicit SyncParametersClient(
    NodeT node, const std::string & remote_node_name = "", const QosT & qos_profile = ParametersQoS())
  : _client(std::make_shared<AsyncParametersClient>(node, remote_node_name, qos_profile)) {}
  template<typename QosT = QoS>
  SyncParametersClient(
    Executor::SharedPtr executor, AnyNode::SharedPtr node, const std::string & remote_node_name = "",
    const QosT & qos_profile = ParametersQoS())
  : _client(std::make_shared<AsyncParametersClient>(node, remote_node_name, qos_profile)) {}

  template<typename... ArgsT>
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return detail::remote_parameters(names);
  }
  bool has_parameter(const std::string & parameter_name)
  {
    return rosward::unknown("message", "parameters of another node", "bool");
  }
  template<typename T, typename... ArgsT>
  T get_parameter(const std::string & parameter_name, const ArgsT & ... default_value)
  {
    return rosward::unknown("message", "value of a parameter of another node");
  }
  template<typename... ArgsT>
  auto describe_parameters(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return rosward::unknown("message", "descriptors of parameters");
  }
  template<typename... ArgsT>
  auto get_parameter_types(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return rosward::unknown("message", "types of parameters");
  }
  template<typename... ArgsT>
  auto set_parameters(const std::vector<Parameter> & parameters, const ArgsT & ... timeout)
  {
    return rosward::unknown("message", "results of set_parameters");
  }
  template<typename... ArgsT>
  auto set_parameters_atomically(const std::vector<Parameter> & parameters, const ArgsT & ... timeout)
  {
    return rosward::message<rcl_interfaces::msg::SetParametersResult>();
  }
  template<typename... ArgsT>
  auto delete_parameters(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return rosward::unknown("message", "results of set_parameters");
  }
  template<typename... ArgsT>
  auto load_parameters(const std::string & yaml_filename, const ArgsT & ... timeout)
  {
    return rosward::unknown("message", "results of set_parameters");
  }
  template<typename... ArgsT>
  auto list_parameters(const std::vector<std::string> & prefixes, uint64_t depth, const ArgsT & ... timeout)
  {
    return rosward::message<rcl_interfaces::msg::ListParametersResult>();
  }
  template<typename CallbackT>
  auto on_parameter_event(CallbackT && callback) {return _client->on_parameter_event(callback);}
  template<typename NodeT, typename CallbackT>
  static auto on_parameter_event(NodeT && node, CallbackT && callback)
  {
    return AsyncParametersClient::on_parameter_event(node, callback);
  }
  bool service_is_ready() const {return rosward::unknown("live", "whether a service is there", "bool");}
  template<typename TimeoutT = int>
  bool wait_for_service(const TimeoutT & timeout = -1)
  {
    return rosward::unknown("live", "whether a service is there", "bool");
  }

  AsyncParametersClient::SharedPtr _client;
};

struct ParameterCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterCallbackHandle)
  using ParameterCallbackType = std::function<void(const Parameter &)>;
  std::string parameter_name;
  std::string node_name;
  ParameterCallbackType callback;
};
struct ParameterEventCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventCallbackHandle)
  using ParameterEventCallbackType = std::function<void(const rcl_interfaces::msg::ParameterEvent &)>;
  ParameterEventCallbackType callback;
};

class ParameterEventHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventHandler)
  using ParameterCallbackType = ParameterCallbackHandle::ParameterCallbackType;
  using ParameterEventCallbackType = ParameterEventCallbackHandle::ParameterEventCallbackType;

  template<typename NodeT>
  [[rosward::creator]] explicit ParameterEventHandler(NodeT node, const QoS & qos = ParameterEventsQoS())
  {
    rosward::create(
      "subscription", rosward::interface_of(node), "/parameter_events",
      rosward::type<rcl_interfaces::msg::ParameterEvent>(), qos);
  }
  template<typename CallbackT>
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & parameter_name, CallbackT callback, const std::string & node_name = "")
  {
    rosward::schedule(
      callback, "parameters",
      Parameter(parameter_name, rosward::unknown("parameter", "value, set when it runs")));
    return std::make_shared<ParameterCallbackHandle>();
  }
  template<typename CallbackT>
  ParameterEventCallbackHandle::SharedPtr add_parameter_event_callback(CallbackT callback)
  {
    rosward::schedule(callback, "parameters", rosward::message<rcl_interfaces::msg::ParameterEvent>());
    return std::make_shared<ParameterEventCallbackHandle>();
  }
  template<typename CallbackT>
  auto configure_nodes_filter(const CallbackT & node_names) {return true;}
  void remove_parameter_callback(ParameterCallbackHandle::SharedPtr callback_handle) {}
  void remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr callback_handle) {}
  static bool get_parameter_from_event(
    const rcl_interfaces::msg::ParameterEvent & event, Parameter & parameter, const std::string & parameter_name,
    const std::string & node_name = "")
  {
    parameter = Parameter(parameter_name, rosward::unknown("message", "value of a parameter of another node"));
    return rosward::unknown("message", "parameter event", "bool");
  }
  static Parameter get_parameter_from_event(
    const rcl_interfaces::msg::ParameterEvent & event, const std::string & parameter_name, const std::string & node_name = "")
  {
    return Parameter(parameter_name, rosward::unknown("message", "value of a parameter of another node"));
  }
  static std::vector<Parameter> get_parameters_from_event(const rcl_interfaces::msg::ParameterEvent & event)
  {
    return detail::new_parameters();
  }
};
using ParameterEventsSubscriber = ParameterEventHandler;
}  // namespace rclcpp
