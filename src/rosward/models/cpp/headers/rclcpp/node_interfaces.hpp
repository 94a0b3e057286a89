// SPDX-License-Identifier: Apache-2.0
// rclcpp::node_interfaces, and the functions beside the methods of a node that take one, a pointer to one, or its interfaces.
//
// Read from rclcpp, branches humble, jazzy and rolling (node_interfaces/*, create_*.hpp, wait_for_message.hpp, copy_all_parameter_values.hpp).

namespace rclcpp
{
namespace node_interfaces
{
using NodeBaseInterface = AnyNode;
using NodeClockInterface = AnyNode;
using NodeGraphInterface = AnyNode;
using NodeLoggingInterface = AnyNode;
using NodeParametersInterface = AnyNode;
using NodeServicesInterface = AnyNode;
using NodeTimeSourceInterface = AnyNode;
using NodeTimersInterface = AnyNode;
using NodeTopicsInterface = AnyNode;
using NodeTypeDescriptionsInterface = AnyNode;
using NodeWaitablesInterface = AnyNode;

template<typename... InterfaceTs>
class NodeInterfaces
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeInterfaces)
  NodeInterfaces() {}
  template<typename NodeT, typename... OthersT>
  NodeInterfaces(const NodeT & node, const OthersT & ... others) : _node(rosward::interface_of(node)) {}

  AnyNode * get_node_base_interface() const {return _node;}
  AnyNode * get_node_clock_interface() const {return _node;}
  AnyNode * get_node_graph_interface() const {return _node;}
  AnyNode * get_node_logging_interface() const {return _node;}
  AnyNode * get_node_timers_interface() const {return _node;}
  AnyNode * get_node_topics_interface() const {return _node;}
  AnyNode * get_node_services_interface() const {return _node;}
  AnyNode * get_node_waitables_interface() const {return _node;}
  AnyNode * get_node_parameters_interface() const {return _node;}
  AnyNode * get_node_time_source_interface() const {return _node;}
  AnyNode * get_node_type_descriptions_interface() const {return _node;}
  template<typename InterfaceT>
  AnyNode * get() const {return _node;}

  AnyNode * _node = nullptr;
};

template<typename NodeT>
AnyNode * get_node_base_interface(NodeT && node) {return rosward::interface_of(node);}
template<typename NodeT>
AnyNode * get_node_parameters_interface(NodeT && node) {return rosward::interface_of(node);}
template<typename NodeT>
AnyNode * get_node_timers_interface(NodeT && node) {return rosward::interface_of(node);}
template<typename NodeT>
AnyNode * get_node_topics_interface(NodeT && node) {return rosward::interface_of(node);}
}  // namespace node_interfaces

// Topics. In place of a node: two of its interfaces, of parameters and of topics.

template<typename MessageT, typename AllocatorT = std::allocator<void>, typename PublisherT = Publisher<MessageT>, typename NodeT>
[[rosward::creator]] std::shared_ptr<PublisherT> create_publisher(
  NodeT && node, const std::string & topic_name, const QoS & qos, const PublisherOptions & options = PublisherOptions())
{
  return rosward::interface_of(node)->template _advertise<MessageT, PublisherT>(topic_name, qos, options);
}
template<typename MessageT, typename AllocatorT = std::allocator<void>, typename PublisherT = Publisher<MessageT>>
[[rosward::creator]] std::shared_ptr<PublisherT> create_publisher(
  AnyNode::SharedPtr & node_parameters, AnyNode::SharedPtr & node_topics, const std::string & topic_name, const QoS & qos,
  const PublisherOptions & options = PublisherOptions())
{
  return node_topics->template _advertise<MessageT, PublisherT>(topic_name, qos, options);
}
template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
  typename SubscriptionT = Subscription<MessageT>, typename NodeT>
[[rosward::creator]] std::shared_ptr<SubscriptionT> create_subscription(
  NodeT && node, const std::string & topic_name, const QoS & qos, CallbackT && callback,
  const SubscriptionOptions & options = SubscriptionOptions(), std::shared_ptr<void> strategy = nullptr)
{
  return rosward::interface_of(node)->template _subscribe<MessageT, SubscriptionT>(topic_name, qos, callback, options);
}
template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
  typename SubscriptionT = Subscription<MessageT>>
[[rosward::creator]] std::shared_ptr<SubscriptionT> create_subscription(
  AnyNode::SharedPtr & node_parameters, AnyNode::SharedPtr & node_topics, const std::string & topic_name, const QoS & qos,
  CallbackT && callback, const SubscriptionOptions & options = SubscriptionOptions(), std::shared_ptr<void> strategy = nullptr)
{
  return node_topics->template _subscribe<MessageT, SubscriptionT>(topic_name, qos, callback, options);
}
template<typename AllocatorT = std::allocator<void>, typename NodeT>
[[rosward::creator]] std::shared_ptr<GenericPublisher> create_generic_publisher(
  NodeT && topics_interface, const std::string & topic_name, const std::string & topic_type, const QoS & qos,
  const PublisherOptions & options = PublisherOptions())
{
  return rosward::interface_of(topics_interface)->_publish_generic(topic_name, topic_type, qos, options);
}
template<typename CallbackT, typename AllocatorT = std::allocator<void>, typename NodeT>
[[rosward::creator]] std::shared_ptr<GenericSubscription> create_generic_subscription(
  NodeT && topics_interface, const std::string & topic_name, const std::string & topic_type, const QoS & qos,
  CallbackT && callback, const SubscriptionOptions & options = SubscriptionOptions())
{
  return rosward::interface_of(topics_interface)->_subscribe_generic(topic_name, topic_type, qos, callback, options);
}

// Services: interfaces only

template<typename ServiceT, typename BaseT, typename GraphT, typename ServicesT, typename QosT = QoS>
[[rosward::creator]] std::shared_ptr<Client<ServiceT>> create_client(
  BaseT && node_base, GraphT && node_graph, ServicesT && node_services, const std::string & service_name,
  const QosT & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return rosward::interface_of(node_base)->template _create_client<ServiceT>(service_name, qos);
}
template<typename ServiceT, typename CallbackT, typename BaseT, typename ServicesT, typename QosT = QoS>
[[rosward::creator]] std::shared_ptr<Service<ServiceT>> create_service(
  BaseT && node_base, ServicesT && node_services, const std::string & service_name, CallbackT && callback,
  const QosT & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return rosward::interface_of(node_base)->template _create_service<ServiceT>(service_name, callback, qos);
}
template<typename BaseT, typename GraphT, typename ServicesT>
[[rosward::creator]] std::shared_ptr<GenericClient> create_generic_client(
  BaseT && node_base, GraphT && node_graph, ServicesT && node_services, const std::string & service_name,
  const std::string & service_type, const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return rosward::interface_of(node_base)->_create_generic_client(service_name, service_type, qos);
}
template<typename CallbackT, typename BaseT, typename ServicesT>
[[rosward::creator]] std::shared_ptr<GenericService> create_generic_service(
  BaseT && node_base, ServicesT && node_services, const std::string & service_name, const std::string & service_type,
  CallbackT && callback, const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
{
  return rosward::interface_of(node_base)->_create_generic_service(service_name, service_type, callback, qos);
}

// Timers: of a node, or of its interfaces

template<typename NodeT, typename PeriodT, typename CallbackT>
TimerBase::SharedPtr create_timer(
  NodeT && node, Clock::SharedPtr clock, const PeriodT & period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return rosward::interface_of(node)->AnyNode::create_timer(period, callback);
}
template<typename BaseT, typename TimersT, typename PeriodT, typename CallbackT>
TimerBase::SharedPtr create_timer(
  BaseT && node_base, TimersT && node_timers, Clock::SharedPtr clock, const PeriodT & period, CallbackT && callback,
  CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
{
  return rosward::interface_of(node_base)->AnyNode::create_timer(period, callback);
}
template<typename ClockT, typename PeriodT, typename CallbackT, typename GroupT, typename BaseT, typename TimersT>
TimerBase::SharedPtr create_timer(
  ClockT clock, const PeriodT & period, CallbackT && callback, GroupT group, BaseT * node_base, TimersT * node_timers,
  bool autostart = true)
{
  return rosward::interface_of(node_base)->AnyNode::create_timer(period, callback);
}
template<typename PeriodT, typename CallbackT, typename GroupT, typename BaseT, typename TimersT>
TimerBase::SharedPtr create_wall_timer(
  const PeriodT & period, CallbackT callback, GroupT group, BaseT * node_base, TimersT * node_timers, bool autostart = true)
{
  return rosward::interface_of(node_base)->AnyNode::create_timer(period, callback);
}

template<typename MessageT, typename NodeT, typename TimeoutT = int>
[[rosward::creator]] bool wait_for_message(
  MessageT & out, NodeT node, const std::string & topic, const TimeoutT & time_to_wait = -1, const QoS & qos = SystemDefaultsQoS())
{
  auto subscription = std::make_shared<Subscription<MessageT>>();
  subscription->_node = rosward::interface_of(node);
  subscription->_topic = topic;
  rosward::create("subscription", subscription->_node, topic, rosward::type<MessageT>(), 1);
  MessageInfo info;
  return subscription->take(out, info);
}
template<typename MessageT, typename TimeoutT = int>
bool wait_for_message(
  MessageT & out, std::shared_ptr<Subscription<MessageT>> subscription, std::shared_ptr<Context> context,
  const TimeoutT & time_to_wait = -1)
{
  MessageInfo info;
  return subscription->take(out, info);
}

template<typename SourceT, typename DestinationT>
void copy_all_parameter_values(const SourceT & source, const DestinationT & destination, bool override_existing_params = false)
{
  rosward::copy_parameters(rosward::interface_of(source), rosward::interface_of(destination));
}

std::string extend_name_with_sub_namespace(const std::string & name, const std::string & sub_namespace)
{
  if (sub_namespace.empty() || name.front() == '/' || name.front() == '~') {
    return name;
  }
  return sub_namespace + "/" + name;
}
std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & namespace_, bool is_service = false)
{
  return rosward::expand_name(name, node_name, namespace_);
}
}  // namespace rclcpp
