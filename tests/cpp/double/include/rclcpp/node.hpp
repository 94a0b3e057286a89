// SPDX-License-Identifier: Apache-2.0
// A node.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"

namespace rosward_double
{
// The creations, for whatever stands for a node.
template<typename M, typename P = rclcpp::Publisher<M>>
std::shared_ptr<P> publisher(Core & node, const std::string & topic)
{
  auto made = std::make_shared<P>(node.create("pub", topic, wire_name<M>()));
  node.own(made);
  return made;
}

std::shared_ptr<Entity> statistics(Core & node, const std::string & topic);

template<typename M, typename F, typename Options = rclcpp::SubscriptionOptions>
std::shared_ptr<rclcpp::Subscription<M>> subscription(Core & node, const std::string & topic, F && callback, const Options & options = {})
{
  auto name = node.create("sub", topic, wire_name<M>());
  auto heard = [callback = std::decay_t<F>(std::forward<F>(callback)), name](int turn) mutable { hear<typename Adapted<M>::heard>(callback, name, turn); };
  auto shared = std::make_shared<decltype(heard)>(std::move(heard));
  auto made = std::make_shared<rclcpp::Subscription<M>>(name, [shared](int turn) { (*shared)(turn); });
  const auto state = options.topic_stats_options.state;
  if (state == rclcpp::TopicStatisticsState::Enable || (state == rclcpp::TopicStatisticsState::NodeDefault && node.statistics)) {
    made->statistics = statistics(node, options.topic_stats_options.publish_topic);
  }
  node.own(made);
  return made;
}

template<typename S>
std::shared_ptr<rclcpp::Client<S>> client(Core & node, const std::string & name)
{
  auto made = std::make_shared<rclcpp::Client<S>>(node.create("sc", name, rosidl_generator_traits::name<S>()));
  node.own(made);
  return made;
}

template<typename S, typename F>
std::shared_ptr<rclcpp::Service<S>> service(Core & node, const std::string & name, F && callback)
{
  auto made = std::make_shared<rclcpp::Service<S>>(node.create("ss", name, rosidl_generator_traits::name<S>()));
  made->take(std::decay_t<F>(std::forward<F>(callback)));
  node.own(made);
  return made;
}

template<typename F>
std::shared_ptr<rclcpp::TimerBase> timer(Core & node, F && callback, bool starts = true)
{
  auto made = std::make_shared<rclcpp::TimerBase>(std::decay_t<F>(std::forward<F>(callback)), starts);
  node.own(made);
  return made;
}
}  // namespace rosward_double

namespace rclcpp
{
namespace node_interfaces
{
// Each interface of a node is a way to the node.
class NodeInterface
{
public:
  explicit NodeInterface(std::shared_ptr<rosward_double::Core> core) : core_(std::move(core)) {}
  virtual ~NodeInterface() = default;
  const std::shared_ptr<rosward_double::Core> & core() const { return core_; }
  const char * get_name() const { return core_->name().c_str(); }
  const char * get_namespace() const { return core_->space().c_str(); }
  const char * get_fully_qualified_name() const { return core_->full_name().c_str(); }
  Logger get_logger() const { return Logger(core_->name()); }
  std::shared_ptr<Clock> get_clock() const { return std::make_shared<Clock>(); }
  std::string resolve_topic_name(const std::string & name, bool only_expand = false) const { return core_->resolve(name, false, !only_expand); }
  std::string resolve_service_name(const std::string & name, bool only_expand = false) const { return core_->resolve(name, true, !only_expand); }
  std::string resolve_topic_or_service_name(const std::string & name, bool is_service, bool only_expand = false) const { return core_->resolve(name, is_service, !only_expand); }

private:
  std::shared_ptr<rosward_double::Core> core_;
};
#define ROSWARD_DOUBLE_INTERFACE(NAME) \
  class NAME : public NodeInterface \
  { \
  public: \
    using SharedPtr = std::shared_ptr<NAME>; \
    using NodeInterface::NodeInterface; \
  };
ROSWARD_DOUBLE_INTERFACE(NodeBaseInterface)
ROSWARD_DOUBLE_INTERFACE(NodeClockInterface)
ROSWARD_DOUBLE_INTERFACE(NodeGraphInterface)
ROSWARD_DOUBLE_INTERFACE(NodeLoggingInterface)
ROSWARD_DOUBLE_INTERFACE(NodeTimersInterface)
ROSWARD_DOUBLE_INTERFACE(NodeTopicsInterface)
ROSWARD_DOUBLE_INTERFACE(NodeServicesInterface)
ROSWARD_DOUBLE_INTERFACE(NodeParametersInterface)
ROSWARD_DOUBLE_INTERFACE(NodeTimeSourceInterface)
ROSWARD_DOUBLE_INTERFACE(NodeWaitablesInterface)
#undef ROSWARD_DOUBLE_INTERFACE
}  // namespace node_interfaces

// What nodes and lifecycle nodes share; `P` is the publisher of a message type.
class NodeMethods
{
public:
  NodeMethods(const std::string & name, const std::string & space, const NodeOptions & options);
  virtual ~NodeMethods() = default;
  NodeMethods(const NodeMethods &) = delete;
  NodeMethods & operator=(const NodeMethods &) = delete;
  const std::shared_ptr<rosward_double::Core> & core() const { return core_; }

  const char * get_name() const { return core_->name().c_str(); }
  const char * get_namespace() const { return core_->space().c_str(); }
  const char * get_fully_qualified_name() const { return core_->full_name().c_str(); }
  const std::string & get_sub_namespace() const { return sub_; }
  std::string get_effective_namespace() const;
  Logger get_logger() const { return Logger(core_->name()); }
  Clock::SharedPtr get_clock() { return clock_; }
  Clock::ConstSharedPtr get_clock() const { return clock_; }
  Time now() const { return Time(); }
  const NodeOptions & get_node_options() const { return options_; }
  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool = true) { return std::make_shared<CallbackGroup>(type); }
  size_t count_publishers(const std::string &) const { return 1; }
  size_t count_subscribers(const std::string &) const { return 1; }
  std::vector<std::string> get_node_names() const { return {core_->full_name()}; }
  std::map<std::string, std::vector<std::string>> get_topic_names_and_types() const { return {}; }
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const { return {}; }
  std::shared_ptr<Event> get_graph_event() { return std::make_shared<Event>(); }
  void wait_for_graph_change(std::shared_ptr<Event>, std::chrono::nanoseconds) {}
  std::vector<int> get_publishers_info_by_topic(const std::string &) const { return {}; }

  template<typename M, typename F, typename A = std::allocator<void>>
  std::shared_ptr<Subscription<M>> create_subscription(
    const std::string & topic, const QoS &, F && callback, const SubscriptionOptionsWithAllocator<A> & options = {}, std::shared_ptr<void> = nullptr)
  {
    return rosward_double::subscription<M>(*core_, prefixed(topic), std::forward<F>(callback), options);
  }
  template<typename S, typename Q = QoS>
  std::shared_ptr<Client<S>> create_client(const std::string & name, const Q & = QoS(10), CallbackGroup::SharedPtr = nullptr)
  {
    return rosward_double::client<S>(*core_, prefixed(name));
  }
  template<typename S, typename F, typename Q = QoS>
  std::shared_ptr<Service<S>> create_service(const std::string & name, F && callback, const Q & = QoS(10), CallbackGroup::SharedPtr = nullptr)
  {
    return rosward_double::service<S>(*core_, prefixed(name), std::forward<F>(callback));
  }
  GenericPublisher::SharedPtr create_generic_publisher(const std::string & topic, const std::string & type, const QoS &, const PublisherOptions & = {});
  template<typename F>
  GenericSubscription::SharedPtr create_generic_subscription(
    const std::string & topic, const std::string & type, const QoS &, F callback, const SubscriptionOptions & = {})
  {
    auto made = std::make_shared<GenericSubscription>(
      core_->create("sub", prefixed(topic), type), [callback](int turn) mutable { rosward_double::hear<SerializedMessage>(callback, "", turn); });
    core_->own(made);
    return made;
  }
  GenericClient::SharedPtr create_generic_client(const std::string & name, const std::string & type, const QoS & = QoS(10), CallbackGroup::SharedPtr = nullptr);
  template<typename R, typename P, typename F>
  TimerBase::SharedPtr create_wall_timer(std::chrono::duration<R, P>, F callback, CallbackGroup::SharedPtr = nullptr, bool autostart = true)
  {
    return rosward_double::timer(*core_, std::move(callback), autostart);
  }
  template<typename R, typename P, typename F>
  TimerBase::SharedPtr create_timer(std::chrono::duration<R, P>, F callback, CallbackGroup::SharedPtr = nullptr)
  {
    return rosward_double::timer(*core_, std::move(callback));
  }

  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using Result = rcl_interfaces::msg::SetParametersResult;
  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & value, const Descriptor & descriptor = Descriptor(), bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(), bool ignore_override = false);
  template<typename T>
  auto declare_parameter(
    const std::string & name, const T & value, const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    return declared<T>(declare_parameter(name, ParameterValue(value), descriptor, ignore_override), name);
  }
  template<typename T>
  auto declare_parameter(const std::string & name, const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    const ParameterValue none{typename Kept<T>::type()};
    const auto & found = declare_parameter(name, none.get_type(), descriptor, ignore_override);
    if (found.get_type() == PARAMETER_NOT_SET) {
      throw exceptions::UninitializedStaticallyTypedParameterException(name);
    }
    return declared<T>(found, name);
  }
  template<typename T>
  std::vector<T> declare_parameters(const std::string & space, const std::map<std::string, T> & values, bool ignore_overrides = false)
  {
    std::vector<T> found;
    for (const auto & [name, value] : values) {
      found.push_back(declare_parameter(space.empty() ? name : space + "." + name, value, Descriptor(), ignore_overrides));
    }
    return found;
  }
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const;
  Result set_parameter(const Parameter & parameter) { return set_parameters({parameter}).at(0); }
  std::vector<Result> set_parameters(const std::vector<Parameter> & changed);
  Result set_parameters_atomically(const std::vector<Parameter> & changed);
  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & found) const;
  template<typename T>
  bool get_parameter(const std::string & name, T & variable) const
  {
    Parameter found;
    if (!get_parameter(sub_.empty() ? name : sub_ + "/" + name, found) || found.get_type() == PARAMETER_NOT_SET) {
      return false;
    }
    variable = static_cast<T>(found.template get_value<T>());
    return true;
  }
  template<typename T>
  bool get_parameter_or(const std::string & name, T & variable, const T & alternative) const
  {
    if (get_parameter(name, variable)) {
      return true;
    }
    variable = alternative;
    return false;
  }
  template<typename T>
  T get_parameter_or(const std::string & name, const T & alternative) const
  {
    T found;
    get_parameter_or(name, found, alternative);
    return found;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  template<typename T>
  bool get_parameters(const std::string & prefix, std::map<std::string, T> & values) const
  {
    for (const auto & [name, found] : below(prefix)) {
      values[name] = static_cast<T>(found.template get_value<T>());
    }
    return !below(prefix).empty();
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth) const;
  Descriptor describe_parameter(const std::string & name) const;
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    node_interfaces::OnSetParametersCallbackHandle::Callback callback);
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
    node_interfaces::PostSetParametersCallbackHandle::Callback callback);
  node_interfaces::PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(
    node_interfaces::PreSetParametersCallbackHandle::Callback callback);
  void remove_on_set_parameters_callback(const node_interfaces::OnSetParametersCallbackHandle * handle);

#define ROSWARD_DOUBLE_INTERFACE(METHOD, NAME) \
  node_interfaces::NAME::SharedPtr METHOD() const { return std::make_shared<node_interfaces::NAME>(core_); }
  ROSWARD_DOUBLE_INTERFACE(get_node_clock_interface, NodeClockInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_graph_interface, NodeGraphInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_logging_interface, NodeLoggingInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_timers_interface, NodeTimersInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_topics_interface, NodeTopicsInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_services_interface, NodeServicesInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_parameters_interface, NodeParametersInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_time_source_interface, NodeTimeSourceInterface)
  ROSWARD_DOUBLE_INTERFACE(get_node_waitables_interface, NodeWaitablesInterface)
#undef ROSWARD_DOUBLE_INTERFACE
  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() const { return base_; }

protected:
  NodeMethods(const NodeMethods & parent, const std::string & sub);
  std::string prefixed(const std::string & name) const;

private:
  template<typename T>
  static auto declared(const ParameterValue & value, const std::string & name)
  {
    try {
      return value.template get<T>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException("parameter '" + name + "': " + error.what());
    }
  }
  std::map<std::string, Parameter> below(const std::string & prefix) const;
  std::shared_ptr<rosward_double::Core> core_;
  std::string sub_;
  NodeOptions options_;
  Clock::SharedPtr clock_ = std::make_shared<Clock>(RCL_ROS_TIME);
  node_interfaces::NodeBaseInterface::SharedPtr base_;
};

class Node : public NodeMethods, public std::enable_shared_from_this<Node>
{
public:
  using SharedPtr = std::shared_ptr<Node>;
  using ConstSharedPtr = std::shared_ptr<const Node>;
  using UniquePtr = std::unique_ptr<Node>;
  using WeakPtr = std::weak_ptr<Node>;
  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions()) : NodeMethods(name, "", options) {}
  explicit Node(const std::string & name, const std::string & space, const NodeOptions & options = NodeOptions()) : NodeMethods(name, space, options) {}
  template<typename ... Args>
  static SharedPtr make_shared(Args && ... args)
  {
    return std::make_shared<Node>(std::forward<Args>(args)...);
  }
  SharedPtr create_sub_node(const std::string & sub) { return SharedPtr(new Node(*this, sub)); }

  template<typename M, typename A = std::allocator<void>, typename P = Publisher<M>>
  std::shared_ptr<P> create_publisher(const std::string & topic, const QoS &, const PublisherOptionsWithAllocator<A> & = {})
  {
    return rosward_double::publisher<M, P>(*core(), prefixed(topic));
  }

protected:
  Node(const Node & parent, const std::string & sub) : NodeMethods(parent, sub) {}
};
}  // namespace rclcpp
