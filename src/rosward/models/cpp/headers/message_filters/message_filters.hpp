// SPDX-License-Identifier: Apache-2.0
// message_filters: subscriptions whose messages reach callbacks one by one or in matching sets.
//
// Read from ros2/message_filters, branches humble to rolling (include/message_filters/*).

namespace message_filters
{
class Connection
{
public:
  void disconnect() {}
};

template<typename MessageT>
class MessageEvent
{
public:
  MessageEvent() : _message(rosward::arrived<MessageT>()) {}
  const std::shared_ptr<const MessageT> & getMessage() const {return _message;}
  const std::shared_ptr<const MessageT> & getConstMessage() const {return _message;}
  rclcpp::Time getReceiptTime() const {return rclcpp::Time();}

  std::shared_ptr<const MessageT> _message;
};

template<typename MessageT>
class SimpleFilter
{
public:
  virtual ~SimpleFilter() {}
  template<typename CallbackT, typename... ObjectT>
  Connection registerCallback(const CallbackT & callback, const ObjectT & ... object)
  {
    if (rosward::takes(callback, "MessageEvent")) {
      rosward::schedule(rosward::bound(callback, object...), "message", MessageEvent<MessageT>());
    } else {
      rosward::deliver(rosward::bound(callback, object...), rosward::type<MessageT>());
    }
    return Connection();
  }
  void setName(const std::string & name) {}
  const std::string & getName() {return "";}
  template<typename T>
  void signalMessage(const T & message) {}
};

class SubscriberBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriberBase)
};

template<typename MessageT, typename NodeType = rclcpp::Node>
class Subscriber : public SubscriberBase, public SimpleFilter<MessageT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscriber)
  Subscriber() {}
  template<typename NodeT, typename QosT = rclcpp::QoS>
  [[rosward::creator]] Subscriber(
    NodeT node, const std::string & topic, const QosT & qos = 10,
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    subscribe(node, topic, qos, options);
  }
  template<typename NodeT, typename QosT = rclcpp::QoS>
  [[rosward::creator]] void subscribe(
    NodeT node, const std::string & topic, const QosT & qos = 10,
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    _topic = topic;
    _subscription = rosward::node_behind(node)->template create_subscription<MessageT>(
      topic, rclcpp::detail::as_qos(qos), [](std::shared_ptr<const MessageT>) {}, options);
  }
  void subscribe() {}
  void unsubscribe() {}
  std::string getTopic() const {return _topic;}
  auto getSubscriber() const {return _subscription;}
  template<typename FilterT>
  void connectInput(FilterT & f) {}
  template<typename EventT>
  void add(const EventT & e) {}

  std::string _topic;
  std::shared_ptr<rclcpp::Subscription<MessageT>> _subscription;
};

template<typename MessageT>
class PassThrough : public SimpleFilter<MessageT>
{
public:
  PassThrough() {}
  template<typename FilterT>
  explicit PassThrough(FilterT & f) {}
  template<typename FilterT>
  void connectInput(FilterT & f) {}
  template<typename T>
  void add(const T & message) {}
};

template<typename MessageT>
class Chain : public SimpleFilter<MessageT>
{
public:
  template<typename... ArgsT>
  explicit Chain(const ArgsT & ... args) {}
  template<typename FilterT>
  size_t addFilter(const FilterT & filter) {return 0;}
};

template<typename MessageT>
class TimeSequencer : public SimpleFilter<MessageT>
{
public:
  template<typename... ArgsT>
  TimeSequencer(const ArgsT & ... args) {}
};

template<typename MessageT>
class Cache : public SimpleFilter<MessageT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Cache)
  template<typename... ArgsT>
  explicit Cache(const ArgsT & ... args) {}
  template<typename FilterT>
  void connectInput(FilterT & f) {}
  void setCacheSize(unsigned int cache_size) {}
  template<typename T>
  void add(const T & message) {}
  template<typename T>
  std::vector<std::shared_ptr<const MessageT>> getInterval(const T & start, const T & end) const
  {
    return {rosward::arrived<MessageT>()};
  }
  template<typename T>
  std::vector<std::shared_ptr<const MessageT>> getSurroundingInterval(const T & start, const T & end) const
  {
    return {rosward::arrived<MessageT>()};
  }
  template<typename T>
  std::shared_ptr<const MessageT> getElemBeforeTime(const T & time) const
  {
    return rosward::either(nullptr, rosward::arrived<MessageT>());
  }
  template<typename T>
  std::shared_ptr<const MessageT> getElemAfterTime(const T & time) const
  {
    return rosward::either(nullptr, rosward::arrived<MessageT>());
  }
  rclcpp::Time getLatestTime() const {return rclcpp::Time();}
  rclcpp::Time getOldestTime() const {return rclcpp::Time();}
};

namespace sync_policies
{
template<typename... MessageTs>
struct ApproximateTime
{
  ApproximateTime() {}
  explicit ApproximateTime(uint32_t queue_size) {}
  template<typename T>
  void setAgePenalty(const T & penalty) {}
  template<typename... ArgsT>
  void setInterMessageLowerBound(const ArgsT & ... args) {}
  template<typename T>
  void setMaxIntervalDuration(const T & duration) {}
  template<typename CallbackT>
  static void _register(const CallbackT & callback)
  {
    rosward::schedule(callback, "message", rosward::arrived<MessageTs>()...);
  }
};
template<typename... MessageTs>
struct ExactTime : public ApproximateTime<MessageTs...>
{
  ExactTime() {}
  explicit ExactTime(uint32_t queue_size) {}
};
template<typename... MessageTs>
struct LatestTime : public ApproximateTime<MessageTs...>
{
  LatestTime() {}
  template<typename ClockT>
  explicit LatestTime(const ClockT & clock) {}
};
template<typename... MessageTs>
struct ApproximateEpsilonTime : public ApproximateTime<MessageTs...>
{
  template<typename... ArgsT>
  explicit ApproximateEpsilonTime(const ArgsT & ... args) {}
};
}  // namespace sync_policies

template<typename PolicyT>
class Synchronizer
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Synchronizer)
  template<typename... ArgsT>
  Synchronizer(const ArgsT & ... args) {}
  template<typename... FilterTs>
  void connectInput(FilterTs & ... filters) {}
  template<typename CallbackT, typename... ObjectT>
  Connection registerCallback(const CallbackT & callback, const ObjectT & ... object)
  {
    PolicyT::_register(rosward::bound(callback, object...));
    return Connection();
  }
  PolicyT * getPolicy() {return &_policy;}
  template<typename T>
  void setAgePenalty(const T & penalty) {}
  template<typename... ArgsT>
  void setInterMessageLowerBound(const ArgsT & ... args) {}
  template<typename T>
  void setMaxIntervalDuration(const T & duration) {}
  void setName(const std::string & name) {}
  template<typename... ArgsT>
  void add(const ArgsT & ... args) {}

  PolicyT _policy;
};

template<typename... MessageTs>
class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<MessageTs...>>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSynchronizer)
  template<typename... ArgsT>
  TimeSynchronizer(const ArgsT & ... args) {}
};
}  // namespace message_filters
