// SPDX-License-Identifier: Apache-2.0
// tf2_ros: transforms over /tf and /tf_static. A listener that is given no node makes one of its own.
//
// Read from ros2/geometry2, branches humble to rolling (tf2_ros/include/tf2_ros/*, src/transform_listener.cpp, buffer.cpp, buffer_server.cpp).

namespace tf2_ros
{
class DynamicListenerQoS : public rclcpp::QoS
{
public:
  explicit DynamicListenerQoS(size_t depth = 100) : rclcpp::QoS(depth) {}
};
class DynamicBroadcasterQoS : public rclcpp::QoS
{
public:
  explicit DynamicBroadcasterQoS(size_t depth = 100) : rclcpp::QoS(depth) {}
};
class StaticListenerQoS : public rclcpp::QoS
{
public:
  explicit StaticListenerQoS(size_t depth = 100) : rclcpp::QoS(depth) {transient_local();}
};
class StaticBroadcasterQoS : public rclcpp::QoS
{
public:
  explicit StaticBroadcasterQoS(size_t depth = 1) : rclcpp::QoS(depth) {transient_local();}
};

namespace detail
{
// What parameters may override of the QoS of /tf and /tf_static.
template<typename NodeT>
void declare_dynamic(const NodeT & node, const std::string & kind, const rclcpp::QoS & qos)
{
  rclcpp::detail::declare_qos_parameters(
    rosward::interface_of(node), kind, "/tf", qos,
    rclcpp::QosOverridingOptions(
      {rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::Durability, rclcpp::QosPolicyKind::History,
        rclcpp::QosPolicyKind::Reliability}));
}
template<typename NodeT>
void declare_static(const NodeT & node, const std::string & kind, const rclcpp::QoS & qos)
{
  rclcpp::detail::declare_qos_parameters(
    rosward::interface_of(node), kind, "/tf_static", qos,
    rclcpp::QosOverridingOptions(
      {rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::History, rclcpp::QosPolicyKind::Reliability}));
}
}  // namespace detail

class CreateTimerInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CreateTimerInterface)
};
class CreateTimerROS : public CreateTimerInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CreateTimerROS)
  template<typename... ArgsT>
  CreateTimerROS(const ArgsT & ... args) {}
};

class BufferInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(BufferInterface)
  virtual ~BufferInterface() {}
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] geometry_msgs::msg::TransformStamped lookupTransform(const ArgsT & ... args) const
  {
    tf2::detail::may_be_missing();
    return rosward::message<geometry_msgs::msg::TransformStamped>();
  }
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] bool canTransform(const ArgsT & ... args) const {return rosward::unknown("live", "whether a transform is there", "bool");}
  template<typename InT, typename OutT, typename... ArgsT>
  [[rosward::holds, rosward::source("tf"), rosward::changes("out")]] OutT & transform(
    const InT & in, OutT & out, const std::string & target_frame, const ArgsT & ... args) const
  {
    tf2::detail::may_be_missing();
    return out;
  }
  template<typename InT, typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] InT transform(
    const InT & in, const std::string & target_frame, const ArgsT & ... args) const
  {
    tf2::detail::may_be_missing();
    return in;
  }
};

class Buffer : public BufferInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Buffer)
  template<typename ClockT, typename DurationT = int, typename NodeT = int>
  [[rosward::creator]] Buffer(
    const ClockT & clock, const DurationT & cache_time = 0, const NodeT & node = nullptr,
    const rclcpp::QoS & qos = rclcpp::ServicesQoS())
  {
    if (node != nullptr) {
      rosward::create(
        "service_server", rosward::interface_of(node), "tf2_frames", rosward::type<tf2_msgs::srv::FrameGraph>(), qos);
    }
  }
  template<typename CallbackT, typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] auto waitForTransform(const std::string & target, const std::string & source, const ArgsT & ... args)
  {
    return rosward::unknown("live", "transform");
  }
  template<typename T>
  void setCreateTimerInterface(const T & create_timer_interface) {}
  void setUsingDedicatedThread(bool value) {}
  template<typename... ArgsT>
  bool setTransform(const ArgsT & ... args) {return true;}
  template<typename FutureT>
  void cancel(const FutureT & future) {}
  void clear() {}
  [[rosward::source("tf")]] std::vector<std::string> getAllFrameNames() const {return rosward::unknown("live", "frames");}
  [[rosward::source("tf")]] std::string allFramesAsYAML() const {return rosward::unknown("live", "frames", "str");}
  [[rosward::source("tf")]] std::string allFramesAsString() const {return rosward::unknown("live", "frames", "str");}
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] bool _frameExists(const ArgsT & ... args) const {return rosward::unknown("live", "frames", "bool");}
};

class TransformListener
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TransformListener)
  using RequiredInterfaces = rclcpp::node_interfaces::NodeInterfaces<>;
  template<typename BufferT>
  [[rosward::creator]] explicit TransformListener(BufferT & buffer, bool spin_thread = true, bool static_only = false)
  {
    const std::vector<std::string> words = {
      "--ros-args", "-r", "__node:=" + std::string("transform_listener_impl_") + rosward::unknown("anew", "address", "str")};
    rclcpp::NodeOptions options(words, true);
    options.start_parameter_event_publisher(false);
    options.start_parameter_services(false);
    _own = rclcpp::Node::make_shared("_", options);
    _listen(_own, DynamicListenerQoS(), StaticListenerQoS(), static_only);
  }
  template<typename BufferT, typename NodeT>
  [[rosward::creator]] TransformListener(
    BufferT & buffer, NodeT && node, bool spin_thread = true, const rclcpp::QoS & qos = DynamicListenerQoS(),
    const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions(),
    const rclcpp::SubscriptionOptions & static_options = rclcpp::SubscriptionOptions(), bool static_only = false)
  {
    _listen(node, qos, static_qos, static_only);
  }
  template<typename BufferT, typename BaseT, typename LoggingT, typename ParametersT, typename TopicsT>
  [[rosward::creator]] TransformListener(
    BufferT & buffer, BaseT node_base, LoggingT node_logging, ParametersT node_parameters, TopicsT node_topics,
    bool spin_thread = true, const rclcpp::QoS & qos = DynamicListenerQoS(),
    const rclcpp::QoS & static_qos = StaticListenerQoS(),
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions(),
    const rclcpp::SubscriptionOptions & static_options = rclcpp::SubscriptionOptions(), bool static_only = false)
  {
    _listen(node_base, qos, static_qos, static_only);
  }
  virtual ~TransformListener() {}

  template<typename NodeT>
  void _listen(const NodeT & node, const rclcpp::QoS & qos, const rclcpp::QoS & static_qos, bool static_only)
  {
    detail::declare_static(node, "subscription", static_qos);
    if (!static_only) {
      detail::declare_dynamic(node, "subscription", qos);
      rosward::create("subscription", rosward::interface_of(node), "/tf", rosward::type<tf2_msgs::msg::TFMessage>(), qos);
    }
    rosward::create(
      "subscription", rosward::interface_of(node), "/tf_static", rosward::type<tf2_msgs::msg::TFMessage>(), static_qos);
  }

  rclcpp::Node::SharedPtr _own;
};

class StaticTransformListener : public TransformListener
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticTransformListener)
  template<typename BufferT>
  [[rosward::creator]] explicit StaticTransformListener(BufferT & buffer, bool spin_thread = true)
  : TransformListener(buffer, spin_thread, true) {}
  template<typename BufferT, typename NodeT>
  [[rosward::creator]] StaticTransformListener(
    BufferT & buffer, NodeT && node, bool spin_thread = true, const rclcpp::QoS & static_qos = StaticListenerQoS())
  : TransformListener(
      buffer, node, spin_thread, rclcpp::QoS(1), static_qos, rclcpp::SubscriptionOptions(), rclcpp::SubscriptionOptions(), true)
  {}
};

class TransformBroadcaster
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TransformBroadcaster)
  using RequiredInterfaces = rclcpp::node_interfaces::NodeInterfaces<>;
  template<typename NodeT>
  [[rosward::creator]] explicit TransformBroadcaster(
    NodeT && node, const rclcpp::QoS & qos = DynamicBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node, qos);
  }
  template<typename ParametersT, typename TopicsT>
  [[rosward::creator]] TransformBroadcaster(
    ParametersT node_parameters, TopicsT node_topics, const rclcpp::QoS & qos = DynamicBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node_topics, qos);
  }
  template<typename T>
  [[rosward::sink("tf")]] void sendTransform(const T & transform) {}
  template<typename NodeT>
  void _advertise(const NodeT & node, const rclcpp::QoS & qos)
  {
    detail::declare_dynamic(node, "publisher", qos);
    rosward::create("publisher", rosward::interface_of(node), "/tf", rosward::type<tf2_msgs::msg::TFMessage>(), qos);
  }
};

class StaticTransformBroadcaster
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticTransformBroadcaster)
  using RequiredInterfaces = rclcpp::node_interfaces::NodeInterfaces<>;
  template<typename NodeT>
  [[rosward::creator]] explicit StaticTransformBroadcaster(
    NodeT && node, const rclcpp::QoS & qos = StaticBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node, qos);
  }
  template<typename ParametersT, typename TopicsT>
  [[rosward::creator]] StaticTransformBroadcaster(
    ParametersT node_parameters, TopicsT node_topics, const rclcpp::QoS & qos = StaticBroadcasterQoS(),
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node_topics, qos);
  }
  template<typename T>
  [[rosward::sink("tf")]] void sendTransform(const T & transform) {}
  template<typename NodeT>
  void _advertise(const NodeT & node, const rclcpp::QoS & qos)
  {
    detail::declare_static(node, "publisher", qos);
    rosward::create("publisher", rosward::interface_of(node), "/tf_static", rosward::type<tf2_msgs::msg::TFMessage>(), qos);
  }
};

class BufferServer
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(BufferServer)
  template<typename BufferT, typename NodeT, typename PeriodT = int>
  [[rosward::creator]] BufferServer(
    const BufferT & buffer, NodeT node, const std::string & ns, const PeriodT & check_period = 0)
  {
    rosward::create("action_server", rosward::interface_of(node), ns, rosward::type<tf2_msgs::action::LookupTransform>());
  }
};

class BufferClient : public BufferInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(BufferClient)
  template<typename NodeT, typename... ArgsT>
  [[rosward::creator]] BufferClient(NodeT node, const std::string & ns, const ArgsT & ... args)
  {
    rosward::create("action_client", rosward::interface_of(node), ns, rosward::type<tf2_msgs::action::LookupTransform>());
  }
  template<typename... ArgsT>
  bool waitForServer(const ArgsT & ... timeout) {return rosward::unknown("live", "whether an action server is there", "bool");}
};

template<typename MessageT, typename BufferT = Buffer>
class MessageFilter : public message_filters::SimpleFilter<MessageT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageFilter)
  template<typename... ArgsT>
  MessageFilter(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void connectInput(const ArgsT & ... args) {}
  void setTargetFrame(const std::string & target_frame) {}
  template<typename T>
  void setTargetFrames(const T & target_frames) {}
  template<typename T>
  void setTolerance(const T & tolerance) {}
  std::string getTargetFramesString();
  void setQueueSize(uint32_t new_queue_size) {}
  void clear() {}
};

[[rosward::holds]] inline auto fromMsg(const builtin_interfaces::msg::Time & time) {return rosward::unknown("call", "time");}
template<typename T>
auto fromRclcpp(const T & time) {return rosward::unknown("call", "time");}
template<typename T>
auto toRclcpp(const T & time) {return rclcpp::Time();}
}  // namespace tf2_ros
