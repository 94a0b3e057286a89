// SPDX-License-Identifier: Apache-2.0
// rclcpp: what can be done with a publisher, and with a subscription?
//
// `_node` is the node, `_topic` the name before it is expanded. Read from rclcpp, branches humble, jazzy and rolling (publisher.hpp,
// publisher_base.hpp, generic_publisher.hpp, subscription.hpp, subscription_base.hpp, generic_subscription.hpp).

namespace rclcpp
{
class PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase)
  PublisherBase() {}
  virtual ~PublisherBase() {}
  const char * get_topic_name() const {return rosward::resolve_name(_node, _topic, "topic");}
  size_t get_subscription_count() const {return rosward::unknown("live", "subscriptions of a topic", "int");}
  size_t get_intra_process_subscription_count() const {return rosward::unknown("live", "subscriptions of a topic", "int");}
  size_t get_queue_size() const;
  bool is_durability_transient_local() const;
  bool assert_liveliness() const {return true;}
  bool can_loan_messages() const;
  QoS get_actual_qos() const {return _qos;}
  template<typename DurationT>
  bool wait_for_all_acked(DurationT timeout) const {return rosward::unknown("live", "whether all is acknowledged", "bool");}

  rosward::value _node;
  std::string _topic;
  rosward::value _qos;
};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher)
  using MessageType = MessageT;
  using PublishedType = detail::custom_t<MessageT>;
  using ROSMessageType = detail::wire_t<MessageT>;
  using MessageSharedPtr = std::shared_ptr<const MessageT>;
  using MessageUniquePtr = std::unique_ptr<MessageT>;

  Publisher() {}
  virtual ~Publisher() {}
  LoanedMessage<MessageT> borrow_loaned_message() {return LoanedMessage<MessageT>();}
  template<typename T>
  void publish(const T & message) {rosward::send("publication", _node, _topic, detail::wire_type<MessageT>(), message);}
};

class GenericPublisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)
  void publish(const SerializedMessage & message) {rosward::send("publication", _node, _topic, _type, message);}
  void publish_as_loaned_msg(const SerializedMessage & message) {publish(message);}

  rosward::value _type;
};

class SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriptionBase)
  SubscriptionBase() {}
  virtual ~SubscriptionBase() {}
  const char * get_topic_name() const {return rosward::resolve_name(_node, _topic, "topic");}
  size_t get_publisher_count() const {return rosward::unknown("live", "publishers of a topic", "int");}
  QoS get_actual_qos() const {return _qos;}
  bool is_serialized() const;
  bool can_loan_messages() const;
  bool is_cft_enabled() const;
  void set_content_filter(const std::string & filter_expression, const std::vector<std::string> & expression_parameters = std::vector<std::string>()) {}
  ContentFilterOptions get_content_filter() const {return ContentFilterOptions();}
  template<typename CallbackT>
  void set_on_new_message_callback(CallbackT callback) {rosward::schedule(callback, "message", 1);}
  void clear_on_new_message_callback() {}

  rosward::value _node;
  std::string _topic;
  rosward::value _qos;
};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription)
  using MessageType = MessageT;
  using SubscribedType = detail::custom_t<MessageT>;
  using ROSMessageType = detail::wire_t<MessageT>;

  Subscription() {}
  virtual ~Subscription() {}
  bool take(MessageT & message_out, MessageInfo & message_info_out)
  {
    rosward::fill(message_out);
    return rosward::unknown("live", "whether a message is there", "bool");
  }
  std::shared_ptr<MessageT> create_message() {return std::make_shared<MessageT>();}
};

class GenericSubscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)
};
}  // namespace rclcpp
