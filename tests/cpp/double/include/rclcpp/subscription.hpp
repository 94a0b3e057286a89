// SPDX-License-Identifier: Apache-2.0
// What hears: twice a message, with nothing but default values where it is not observed.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <type_traits>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp
{
class MessageInfo
{
public:
  MessageInfo() = default;
};

enum class TopicStatisticsState { Enable, Disable, NodeDefault };

template<typename AllocatorT>
struct SubscriptionOptionsWithAllocator
{
  struct TopicStatsOptions
  {
    TopicStatisticsState state = TopicStatisticsState::NodeDefault;
    std::string publish_topic = "/statistics";
    std::chrono::milliseconds publish_period{1000};
  } topic_stats_options;
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  std::shared_ptr<CallbackGroup> callback_group;
  std::shared_ptr<AllocatorT> allocator;
  QosOverridingOptions qos_overriding_options;
  int use_intra_process_comm = 0;
  struct ContentFilterOptions
  {
    std::string filter_expression;
    std::vector<std::string> expression_parameters;
  } content_filter_options;
};
using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

class SubscriptionBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<SubscriptionBase>;
  using ConstSharedPtr = std::shared_ptr<const SubscriptionBase>;
  using WeakPtr = std::weak_ptr<SubscriptionBase>;
  SubscriptionBase(std::string topic, std::function<void(int)> callback) : topic_(std::move(topic)), callback_(std::move(callback)) {}
  const char * get_topic_name() const { return topic_.c_str(); }
  size_t get_publisher_count() const { return 1; }
  QoS get_actual_qos() const { return QoS(10); }
  bool serve() override
  {
    if (!turn()) {
      return false;
    }
    callback_(turns());
    return true;
  }
  std::shared_ptr<rosward_double::Entity> statistics;

private:
  std::string topic_;
  std::function<void(int)> callback_;
};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  using SharedPtr = std::shared_ptr<Subscription>;
  using ConstSharedPtr = std::shared_ptr<const Subscription>;
  using UniquePtr = std::unique_ptr<Subscription>;
  using WeakPtr = std::weak_ptr<Subscription>;
  using SubscribedType = typename rosward_double::Adapted<MessageT>::heard;
  using ROSMessageType = typename rosward_double::Adapted<MessageT>::wire;
  using SubscriptionBase::SubscriptionBase;
  bool take(MessageT &, MessageInfo &) { return true; }
};

class GenericSubscription : public SubscriptionBase
{
public:
  using SharedPtr = std::shared_ptr<GenericSubscription>;
  using SubscriptionBase::SubscriptionBase;
};
}  // namespace rclcpp

namespace rosward_double
{
// The message that arrives, in the form in which a program takes it.
template<typename M>
std::unique_ptr<M> arrived(const std::string & topic, int turn)
{
  auto made = std::make_unique<M>();
  arrive("topic:" + topic, turn, *made);
  return made;
}

// Calls what takes a message, in whichever form it does.
template<typename M, typename F>
void hear(F & callback, const std::string & topic, int turn)
{
  const rclcpp::MessageInfo info{};
  using Serialized = std::shared_ptr<rclcpp::SerializedMessage>;
  if constexpr (std::is_invocable_v<F &, std::shared_ptr<M>>) {
    callback(std::shared_ptr<M>(arrived<M>(topic, turn)));
  } else if constexpr (std::is_invocable_v<F &, const M &>) {
    callback(*arrived<M>(topic, turn));
  } else if constexpr (std::is_invocable_v<F &, std::unique_ptr<M>>) {
    callback(arrived<M>(topic, turn));
  } else if constexpr (std::is_invocable_v<F &, Serialized>) {
    callback(std::make_shared<rclcpp::SerializedMessage>());
  } else if constexpr (std::is_invocable_v<F &, std::shared_ptr<M>, const rclcpp::MessageInfo &>) {
    callback(std::shared_ptr<M>(arrived<M>(topic, turn)), info);
  } else if constexpr (std::is_invocable_v<F &, const M &, const rclcpp::MessageInfo &>) {
    callback(*arrived<M>(topic, turn), info);
  } else if constexpr (std::is_invocable_v<F &, std::unique_ptr<M>, const rclcpp::MessageInfo &>) {
    callback(arrived<M>(topic, turn), info);
  } else {
    static_assert(std::is_invocable_v<F &, Serialized, const rclcpp::MessageInfo &>, "no callback of a subscription");
    callback(std::make_shared<rclcpp::SerializedMessage>(), info);
  }
}
}  // namespace rosward_double
