// SPDX-License-Identifier: Apache-2.0
// Creations by functions: they know nothing of sub-nodes.
#pragma once

#include "rclcpp/node.hpp"

namespace rclcpp
{
template<typename M, typename NodeT>
std::shared_ptr<Publisher<M>> create_publisher(NodeT && node, const std::string & topic, const QoS &, const PublisherOptions & = {})
{
  return rosward_double::publisher<M>(*rosward_double::core_of(node), topic);
}
template<typename M>
std::shared_ptr<Publisher<M>> create_publisher(
  node_interfaces::NodeParametersInterface::SharedPtr node, node_interfaces::NodeTopicsInterface::SharedPtr, const std::string & topic,
  const QoS &, const PublisherOptions & = {})
{
  return rosward_double::publisher<M>(*node->core(), topic);
}
template<typename M, typename NodeT, typename F>
std::shared_ptr<Subscription<M>> create_subscription(
  NodeT && node, const std::string & topic, const QoS &, F && callback, const SubscriptionOptions & options = {})
{
  return rosward_double::subscription<M>(*rosward_double::core_of(node), topic, std::forward<F>(callback), options);
}
template<typename M, typename F>
std::shared_ptr<Subscription<M>> create_subscription(
  node_interfaces::NodeParametersInterface::SharedPtr node, node_interfaces::NodeTopicsInterface::SharedPtr, const std::string & topic,
  const QoS &, F && callback, const SubscriptionOptions & options = {})
{
  return rosward_double::subscription<M>(*node->core(), topic, std::forward<F>(callback), options);
}
template<typename S>
std::shared_ptr<Client<S>> create_client(
  node_interfaces::NodeBaseInterface::SharedPtr node, node_interfaces::NodeGraphInterface::SharedPtr,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & name, const QoS & = QoS(10), CallbackGroup::SharedPtr = nullptr)
{
  return rosward_double::client<S>(*node->core(), name);
}
template<typename S, typename F>
std::shared_ptr<Service<S>> create_service(
  node_interfaces::NodeBaseInterface::SharedPtr node, node_interfaces::NodeServicesInterface::SharedPtr, const std::string & name,
  F && callback, const QoS & = QoS(10), CallbackGroup::SharedPtr = nullptr)
{
  return rosward_double::service<S>(*node->core(), name, std::forward<F>(callback));
}
template<typename NodeT, typename F>
TimerBase::SharedPtr create_timer(NodeT && node, Clock::SharedPtr, Duration, F && callback, CallbackGroup::SharedPtr = nullptr, bool autostart = true)
{
  return rosward_double::timer(*rosward_double::core_of(node), std::forward<F>(callback), autostart);
}
template<typename R, typename P, typename F>
TimerBase::SharedPtr create_wall_timer(
  std::chrono::duration<R, P>, F callback, CallbackGroup::SharedPtr, node_interfaces::NodeBaseInterface * node, node_interfaces::NodeTimersInterface *)
{
  return rosward_double::timer(*node->core(), std::move(callback));
}
inline GenericPublisher::SharedPtr create_generic_publisher(
  node_interfaces::NodeTopicsInterface::SharedPtr node, const std::string & topic, const std::string & type, const QoS &,
  const PublisherOptions & = {})
{
  auto made = std::make_shared<GenericPublisher>(node->core()->create("pub", topic, type));
  node->core()->own(made);
  return made;
}
template<typename F>
GenericSubscription::SharedPtr create_generic_subscription(
  node_interfaces::NodeTopicsInterface::SharedPtr node, const std::string & topic, const std::string & type, const QoS &, F callback,
  const SubscriptionOptions & = {})
{
  auto made = std::make_shared<GenericSubscription>(
    node->core()->create("sub", topic, type), [callback](int turn) mutable { rosward_double::hear<SerializedMessage>(callback, "", turn); });
  node->core()->own(made);
  return made;
}
template<typename M, typename R = int64_t, typename P = std::milli>
bool wait_for_message(M &, std::shared_ptr<Node> node, const std::string & topic, std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
{
  node->create_subscription<M>(topic, 1, [](std::shared_ptr<const M>) {});
  return true;
}
}  // namespace rclcpp
