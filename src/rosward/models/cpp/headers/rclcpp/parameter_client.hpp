// SPDX-License-Identifier: Apache-2.0
// rclcpp: parameters of other nodes. Six clients under the name of the remote node; a subscription to /parameter_events.
//
// Read from rclcpp, branches humble, jazzy and rolling (parameter_client.hpp, parameter_event_handler.hpp, parameter_events_filter.hpp).

namespace rclcpp
{
namespace detail
{
// A client of a service: what is asked is sent, and what is answered is made of the response.
template<typename ServiceT>
class AskedService : public Client<ServiceT>
{
public:
  template<typename QosT>
  AskedService(AnyNode * node, const std::string & name, const QosT & qos)
  {
    rosward::create("service_client", node, name, rosward::type<ServiceT>(), qos);
    this->_node = node;
    this->_service = name;
  }
  template<typename... ArgsT>
  std::shared_ptr<typename ServiceT::Response> ask(const ArgsT & ... args)
  {
    rosward::send(
      "request", this->_node, this->_service, rosward::type<typename ServiceT::Request>(), std::make_tuple(args...));
    return rosward::arrived<typename ServiceT::Response>();
  }
};

template<typename ResponseT>
std::vector<Parameter> parameters_in(const std::vector<std::string> & names, const ResponseT & response)
{
  std::vector<Parameter> parameters;
  for (const auto & name : names) {
    parameters.push_back(Parameter(name, remote_value(response)));
  }
  return parameters;
}
template<typename ResponseT>
rosward::value remote_value(const ResponseT & response)
{
  return rosward::unknown("message", "value of a parameter of another node");
}
template<typename ResponseT>
bool is_remote(const ResponseT & response)
{
  return rosward::unknown("message", "parameters of another node", "bool");
}
template<typename ResponseT>
rosward::value results_in(const ResponseT & response)
{
  return rosward::unknown("message", "results of set_parameters");
}
template<typename ResponseT>
rosward::value descriptors_in(const ResponseT & response)
{
  return rosward::unknown("message", "descriptors of parameters");
}
template<typename ResponseT>
rosward::value types_in(const ResponseT & response)
{
  return rosward::unknown("message", "types of parameters");
}
}  // namespace detail

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
    _get = std::make_shared<detail::AskedService<rcl_interfaces::srv::GetParameters>>(
      _node, remote + "/get_parameters", qos);
    _get_types = std::make_shared<detail::AskedService<rcl_interfaces::srv::GetParameterTypes>>(
      _node, remote + "/get_parameter_types", qos);
    _set = std::make_shared<detail::AskedService<rcl_interfaces::srv::SetParameters>>(
      _node, remote + "/set_parameters", qos);
    _set_atomically = std::make_shared<detail::AskedService<rcl_interfaces::srv::SetParametersAtomically>>(
      _node, remote + "/set_parameters_atomically", qos);
    _list = std::make_shared<detail::AskedService<rcl_interfaces::srv::ListParameters>>(
      _node, remote + "/list_parameters", qos);
    _describe = std::make_shared<detail::AskedService<rcl_interfaces::srv::DescribeParameters>>(
      _node, remote + "/describe_parameters", qos);
  }

  template<typename... ArgsT>
  auto get_parameters(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<std::vector<Parameter>>(detail::parameters_in(names, _get->ask(names))), callback...);
  }
  template<typename... ArgsT>
  auto describe_parameters(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(detail::descriptors_in(_describe->ask(names))), callback...);
  }
  template<typename... ArgsT>
  auto get_parameter_types(const std::vector<std::string> & names, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(detail::types_in(_get_types->ask(names))), callback...);
  }
  template<typename... ArgsT>
  auto set_parameters(const std::vector<Parameter> & parameters, const ArgsT & ... callback)
  {
    return _answer(detail::Future<rosward::value>(detail::results_in(_set->ask(parameters))), callback...);
  }
  template<typename... ArgsT>
  auto set_parameters_atomically(const std::vector<Parameter> & parameters, const ArgsT & ... callback)
  {
    return _answer(
      detail::Future<rcl_interfaces::msg::SetParametersResult>(_set_atomically->ask(parameters)->result), callback...);
  }
  auto delete_parameters(const std::vector<std::string> & parameters_names)
  {
    return detail::Future<rosward::value>(detail::results_in(_set->ask(parameters_names)));
  }
  template<typename SourceT>
  auto load_parameters(const SourceT & source)
  {
    return detail::Future<rosward::value>(detail::results_in(_set->ask(source)));
  }
  template<typename... ArgsT>
  auto list_parameters(const std::vector<std::string> & prefixes, uint64_t depth, const ArgsT & ... callback)
  {
    return _answer(
      detail::Future<rcl_interfaces::msg::ListParametersResult>(_list->ask(prefixes, depth)->result), callback...);
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
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::GetParameters>> _get;
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::GetParameterTypes>> _get_types;
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::SetParameters>> _set;
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::SetParametersAtomically>> _set_atomically;
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::ListParameters>> _list;
  std::shared_ptr<detail::AskedService<rcl_interfaces::srv::DescribeParameters>> _describe;
};

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
    return _client->get_parameters(names).get();
  }
  bool has_parameter(const std::string & parameter_name)
  {
    return detail::is_remote(_client->_list->ask(parameter_name));
  }
  template<typename T, typename... ArgsT>
  T get_parameter(const std::string & parameter_name, const ArgsT & ... default_value)
  {
    return detail::remote_value(_client->_get->ask(parameter_name));
  }
  template<typename... ArgsT>
  auto describe_parameters(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return _client->describe_parameters(names).get();
  }
  template<typename... ArgsT>
  auto get_parameter_types(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return _client->get_parameter_types(names).get();
  }
  template<typename... ArgsT>
  auto set_parameters(const std::vector<Parameter> & parameters, const ArgsT & ... timeout)
  {
    return _client->set_parameters(parameters).get();
  }
  template<typename... ArgsT>
  auto set_parameters_atomically(const std::vector<Parameter> & parameters, const ArgsT & ... timeout)
  {
    return _client->set_parameters_atomically(parameters).get();
  }
  template<typename... ArgsT>
  auto delete_parameters(const std::vector<std::string> & names, const ArgsT & ... timeout)
  {
    return _client->delete_parameters(names).get();
  }
  template<typename... ArgsT>
  auto load_parameters(const std::string & yaml_filename, const ArgsT & ... timeout)
  {
    return _client->load_parameters(yaml_filename).get();
  }
  template<typename... ArgsT>
  auto list_parameters(const std::vector<std::string> & prefixes, uint64_t depth, const ArgsT & ... timeout)
  {
    return _client->list_parameters(prefixes, depth).get();
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
  : _node(rosward::interface_of(node)), _topic("/parameter_events")
  {
    rosward::create(
      "subscription", _node, _topic, rosward::type<rcl_interfaces::msg::ParameterEvent>(), qos);
  }
  template<typename CallbackT>
  ParameterCallbackHandle::SharedPtr add_parameter_callback(
    const std::string & parameter_name, CallbackT callback, const std::string & node_name = "")
  {
    rosward::schedule(
      callback, "parameters",
      Parameter(parameter_name, rosward::unknown("message", "value of a parameter of another node")));
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
  [[rosward::changes("parameter")]] static bool get_parameter_from_event(
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

  AnyNode * _node = nullptr;
  std::string _topic;
};
using ParameterEventsSubscriber = ParameterEventHandler;
}  // namespace rclcpp
