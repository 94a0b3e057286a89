// SPDX-License-Identifier: Apache-2.0
// Filters: what is joined at the end hears messages with nothing but default values.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace message_filters
{
class Connection
{
public:
  void disconnect() {}
};

// A filter gives what it hears to those that were registered.
class Filter
{
public:
  void pass() const
  {
    const auto all = next_;
    for (const auto & each : all) {
      each();
    }
  }
  void then(std::function<void()> callback) { next_.push_back(std::move(callback)); }

private:
  std::vector<std::function<void()>> next_;
};

template<typename ... M, typename F>
std::function<void()> with_defaults(F callback)
{
  return [callback]() mutable { callback(std::make_shared<const M>()...); };
}

template<typename M>
class SimpleFilter : public Filter
{
public:
  template<typename F>
  Connection registerCallback(F callback)
  {
    then([callback]() mutable {
        if constexpr (std::is_invocable_v<F &, std::shared_ptr<const M>>) {
          callback(std::make_shared<const M>());
        } else {
          callback(M());
        }
      });
    return {};
  }
  template<typename T, typename P>
  Connection registerCallback(void (T::* method)(P), T * object)
  {
    return registerCallback([method, object](const std::shared_ptr<const M> & message) { (object->*method)(message); });
  }
};

template<typename M, typename NodeT = rclcpp::Node>
class Subscriber : public SimpleFilter<M>
{
public:
  Subscriber() = default;
  template<typename N, typename Q = rclcpp::QoS>
  Subscriber(N && node, const std::string & topic, const Q & = rclcpp::QoS(10), const rclcpp::SubscriptionOptions & options = {})
  {
    subscribe(std::forward<N>(node), topic, rclcpp::QoS(10), options);
  }
  template<typename N, typename Q = rclcpp::QoS>
  void subscribe(N && node, const std::string & topic, const Q & = rclcpp::QoS(10), const rclcpp::SubscriptionOptions & = {})
  {
    subscription_ = rosward_double::pointed(node).template create_subscription<M>(topic, rclcpp::QoS(10), [this](std::shared_ptr<const M>) { this->pass(); });
  }
  void subscribe() {}
  void unsubscribe() { subscription_.reset(); }
  std::string getTopic() const { return subscription_ ? subscription_->get_topic_name() : ""; }

private:
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};
}  // namespace message_filters
