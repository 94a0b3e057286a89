// SPDX-License-Identifier: Apache-2.0
// What publishes: nobody hears it, but it may be observed.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/qos.hpp"
#include "rosward_double/contents.hpp"
#include "rosward_double/core.hpp"
#include "rosward_double/messages.hpp"

namespace rclcpp
{
// What stands for a message of ROS: `custom_type` in the program, `ros_message_type` on the wire.
template<typename CustomT, typename RosT = void, typename Enable = void>
struct TypeAdapter
{
  using is_specialized = std::false_type;
  using custom_type = CustomT;
  using ros_message_type = CustomT;
};
template<typename CustomT>
struct ImplicitTypeAdapter
{
  using is_specialized = std::false_type;
};
template<typename CustomT>
struct adapt_type
{
  template<typename RosT>
  using as = TypeAdapter<CustomT, RosT>;
};
#define RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(CUSTOM, ROS) \
  template<> \
  struct rclcpp::ImplicitTypeAdapter<CUSTOM> : rclcpp::TypeAdapter<CUSTOM, ROS> \
  { \
  };
}  // namespace rclcpp

namespace rosward_double
{
// What a program has of a type of messages, and what is on the wire.
template<typename M, typename = void>
struct Adapted
{
  using heard = M;
  using wire = M;
};
template<typename C, typename R>
struct Adapted<rclcpp::TypeAdapter<C, R>, void>
{
  using heard = C;
  using wire = R;
};
template<typename M>
struct Adapted<M, std::enable_if_t<rclcpp::ImplicitTypeAdapter<M>::is_specialized::value>>
{
  using heard = M;
  using wire = typename rclcpp::ImplicitTypeAdapter<M>::ros_message_type;
};
template<typename M>
const char * wire_name()
{
  return rosidl_generator_traits::name<typename Adapted<M>::wire>();
}
}  // namespace rosward_double

namespace rclcpp
{
class SerializedMessage
{
public:
  SerializedMessage() = default;
  explicit SerializedMessage(size_t) {}
  size_t size() const { return 0; }
  size_t capacity() const { return 0; }
};

template<typename MessageT>
class LoanedMessage
{
public:
  MessageT & get() { return message_; }
  bool is_valid() const { return true; }

private:
  MessageT message_;
};

struct MatchedInfo
{
  size_t total_count = 0, total_count_change = 0, current_count = 0;
  int32_t current_count_change = 0;
};
struct EventInfo
{
  int32_t total_count = 0, total_count_change = 0, alive_count = 0, not_alive_count = 0;
};
using QOSDeadlineOfferedInfo = EventInfo;
using QOSDeadlineRequestedInfo = EventInfo;
using QOSLivelinessLostInfo = EventInfo;
using QOSLivelinessChangedInfo = EventInfo;
using QOSOfferedIncompatibleQoSInfo = EventInfo;
using QOSRequestedIncompatibleQoSInfo = EventInfo;
using QOSMessageLostInfo = EventInfo;
struct PublisherEventCallbacks
{
  std::function<void(EventInfo &)> deadline_callback, liveliness_callback, incompatible_qos_callback, message_lost_callback;
  std::function<void(MatchedInfo &)> matched_callback;
};
using SubscriptionEventCallbacks = PublisherEventCallbacks;

template<typename AllocatorT>
struct PublisherOptionsWithAllocator
{
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  std::shared_ptr<CallbackGroup> callback_group;
  std::shared_ptr<AllocatorT> allocator;
  QosOverridingOptions qos_overriding_options;
  int use_intra_process_comm = 0;
};
using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

class PublisherBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<PublisherBase>;
  using WeakPtr = std::weak_ptr<PublisherBase>;
  explicit PublisherBase(std::string topic) : topic_(std::move(topic)) {}
  const char * get_topic_name() const { return topic_.c_str(); }
  size_t get_subscription_count() const { return 1; }
  size_t get_intra_process_subscription_count() const { return 0; }
  size_t get_queue_size() const { return 10; }
  QoS get_actual_qos() const { return QoS(10); }
  bool assert_liveliness() const { return true; }
  bool can_loan_messages() const { return false; }
  template<typename R, typename P>
  bool wait_for_all_acked(std::chrono::duration<R, P>) const
  {
    return true;
  }

private:
  std::string topic_;
};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  using SharedPtr = std::shared_ptr<Publisher>;
  using ConstSharedPtr = std::shared_ptr<const Publisher>;
  using UniquePtr = std::unique_ptr<Publisher>;
  using WeakPtr = std::weak_ptr<Publisher>;
  using PublishedType = typename rosward_double::Adapted<MessageT>::heard;
  using ROSMessageType = typename rosward_double::Adapted<MessageT>::wire;
  using PublisherBase::PublisherBase;
  template<typename T>
  void publish(const T & message)
  {
    rosward_double::leave(std::string("topic:") + get_topic_name(), message);
  }
  template<typename T>
  void publish(std::unique_ptr<T> message)
  {
    publish(*message);
  }
  void publish(const SerializedMessage &) {}
  void publish(LoanedMessage<MessageT> && message) { publish(message.get()); }
  LoanedMessage<MessageT> borrow_loaned_message() { return {}; }
};

class GenericPublisher : public PublisherBase
{
public:
  using SharedPtr = std::shared_ptr<GenericPublisher>;
  using PublisherBase::PublisherBase;
  void publish(const SerializedMessage &) {}
};
}  // namespace rclcpp
