// SPDX-License-Identifier: Apache-2.0
// image_transport: images on one topic for each transport that is installed, plain ones surely; subscriptions by one transport.
//
// Read from ros-perception/image_common, branches humble to rolling (image_transport/include/image_transport/*, src/*.cpp), of
// image_transport_plugins the names and types.

namespace image_transport
{
using RequiredInterfaces = rclcpp::node_interfaces::NodeInterfaces<>;

class TransportHints
{
public:
  TransportHints() {}
  template<typename NodeT>
  TransportHints(
    const NodeT & node, const std::string & default_transport = "raw", const std::string & parameter_name = "image_transport")
  {
    _transport = rosward::interface_of(node)->rclcpp::AnyNode::get_parameter_or(parameter_name, default_transport);
  }
  const std::string & getTransport() const {return _transport;}

  std::string _transport = "raw";
};

namespace detail
{
std::string camera_info(const std::string & base_topic)
{
  const auto slash = base_topic.rfind('/');
  if (slash == std::string::npos) {
    return "camera_info";
  }
  return base_topic.substr(0, slash) + "/camera_info";
}

template<typename NodeT, typename TypeT, typename QosT>
void offer(
  const NodeT & node, const std::string & topic, const TypeT & type, const QosT & qos, const rclcpp::PublisherOptions & options)
{
  rclcpp::detail::declare_qos_parameters(
    node, "publisher", topic, rclcpp::detail::as_qos(qos), options.qos_overriding_options);
  rosward::create("publisher", node, topic, type, qos);
}

// Of each topic a list of transports, all that are installed where it is not given
template<typename NodeT>
void declare_transports(const NodeT & node, const std::string & topic)
{
  std::string name = topic.substr(std::string(node->get_effective_namespace()).length());
  std::replace(name.begin(), name.end(), '/', '.');
  if (name.front() == '.') {
    name = name.substr(1);
  }
  name += ".enable_pub_plugins";
  if (!node->has_parameter(name)) {
    std::vector<std::string> installed = rosward::unknown("environment", "plugins of image_transport");
    node->declare_parameter(name, installed);
  }
}

template<typename NodeT, typename QosT>
void advertise(
  const NodeT & node, const std::string & base_topic, const QosT & qos,
  const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
{
  declare_transports(node, rosward::resolve_name(node, base_topic, "topic"));
  rclcpp::detail::schedule_events(options.event_callbacks);
  offer(node, base_topic, rosward::type<sensor_msgs::msg::Image>(), qos, options);
  if (rosward::unknown("environment", "plugins of image_transport", "bool")) {
    auto compressed = rosward::type<sensor_msgs::msg::CompressedImage>();
    offer(node, base_topic + "/compressed", compressed, qos, options);
    offer(node, base_topic + "/compressedDepth", compressed, qos, options);
    offer(node, base_topic + "/zstd", compressed, qos, options);
    offer(node, base_topic + "/theora", rosward::type<theora_image_transport::msg::Packet>(), qos, options);
  }
}

template<typename NodeT, typename QosT, typename CallbackT>
void subscribe(
  const NodeT & node, const std::string & base_topic, const std::string & transport, const QosT & qos, const CallbackT & callback)
{
  if (transport == "raw") {
    rosward::create("subscription", node, base_topic, rosward::type<sensor_msgs::msg::Image>(), qos, callback);
  } else if (transport == "theora") {
    rosward::create(
      "subscription", node, base_topic + "/theora", rosward::type<theora_image_transport::msg::Packet>(), qos, callback);
  } else {
    rosward::create(
      "subscription", node, base_topic + "/" + transport, rosward::type<sensor_msgs::msg::CompressedImage>(), qos, callback);
  }
}
}  // namespace detail

class Publisher
{
public:
  Publisher() {}
  template<typename NodeT, typename LoaderT, typename QosT = rclcpp::QoS>
  [[rosward::creator]] Publisher(
    const NodeT & node, const std::string & base_topic, const LoaderT & loader, const QosT & custom_qos = rmw_qos_profile_default,
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node, base_topic, custom_qos, options);
  }
  template<typename NodeT, typename QosT>
  void _advertise(
    const NodeT & node, const std::string & base_topic, const QosT & qos,
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _node = rosward::interface_of(node);
    _topic = base_topic;
    detail::advertise(_node, base_topic, qos, options);
  }
  size_t getNumSubscribers() const {return rosward::unknown("live", "subscriptions of a topic", "int");}
  std::string getTopic() const {return rosward::resolve_name(_node, _topic, "topic");}
  template<typename MessageT>
  void publish(const MessageT & message) const
  {
    rosward::send("publication", _node, _topic, rosward::type<sensor_msgs::msg::Image>(), message);
  }
  void shutdown() {}
  operator bool() const {return _node != nullptr;}

  rosward::value _node;
  std::string _topic;
};

class CameraPublisher
{
public:
  CameraPublisher() {}
  template<typename NodeT, typename QosT = rclcpp::QoS>
  [[rosward::creator]] CameraPublisher(
    const NodeT & node, const std::string & base_topic, const QosT & custom_qos = rmw_qos_profile_default,
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _advertise(node, base_topic, custom_qos, options);
  }
  template<typename NodeT, typename QosT>
  void _advertise(
    const NodeT & node, const std::string & base_topic, const QosT & qos,
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    _node = rosward::interface_of(node);
    _topic = base_topic;
    detail::advertise(_node, base_topic, qos, options);
    rosward::create(
      "publisher", _node, detail::camera_info(base_topic), rosward::type<sensor_msgs::msg::CameraInfo>(), qos);
  }
  size_t getNumSubscribers() const {return rosward::unknown("live", "subscriptions of a topic", "int");}
  std::string getTopic() const {return rosward::resolve_name(_node, _topic, "topic");}
  std::string getInfoTopic() const {return rosward::resolve_name(_node, detail::camera_info(_topic), "topic");}
  template<typename ImageT, typename InfoT, typename... StampT>
  void publish(const ImageT & image, const InfoT & info, const StampT & ... stamp) const
  {
    rosward::send("publication", _node, _topic, rosward::type<sensor_msgs::msg::Image>(), image);
    rosward::send("publication", _node, detail::camera_info(_topic), rosward::type<sensor_msgs::msg::CameraInfo>(), info);
  }
  void shutdown() {}
  operator bool() const {return _node != nullptr;}

  rosward::value _node;
  std::string _topic;
};

class Subscriber
{
public:
  typedef std::function<void(const sensor_msgs::msg::Image::ConstSharedPtr &)> Callback;
  Subscriber() {}
  template<typename NodeT, typename CallbackT, typename LoaderT, typename QosT = rclcpp::QoS, typename... OptionsT>
  [[rosward::creator]] Subscriber(
    const NodeT & node, const std::string & base_topic, const CallbackT & callback, const LoaderT & loader,
    const std::string & transport, const QosT & custom_qos = rmw_qos_profile_default, const OptionsT & ... options)
  {
    _subscribe(node, base_topic, transport, custom_qos, callback);
  }
  std::string getTopic() const {return rosward::resolve_name(_node, _topic, "topic");}
  size_t getNumPublishers() const {return rosward::unknown("live", "publishers of a topic", "int");}
  std::string getTransport() const {return _transport;}
  void shutdown() {}
  operator bool() const {return _node != nullptr;}
  template<typename NodeT, typename QosT, typename CallbackT>
  void _subscribe(
    const NodeT & node, const std::string & base_topic, const std::string & transport, const QosT & qos, const CallbackT & callback)
  {
    _node = rosward::interface_of(node);
    _topic = base_topic;
    _transport = transport;
    detail::subscribe(_node, base_topic, transport, qos, callback);
    rosward::deliver(callback, rosward::type<sensor_msgs::msg::Image>());
  }

  rosward::value _node;
  std::string _topic;
  std::string _transport;
};

class CameraSubscriber
{
public:
  typedef std::function<
      void(const sensor_msgs::msg::Image::ConstSharedPtr &, const sensor_msgs::msg::CameraInfo::ConstSharedPtr &)> Callback;
  CameraSubscriber() {}
  template<typename NodeT, typename CallbackT, typename QosT = rclcpp::QoS>
  [[rosward::creator]] CameraSubscriber(
    const NodeT & node, const std::string & base_topic, const CallbackT & callback, const std::string & transport,
    const QosT & custom_qos = rmw_qos_profile_default)
  {
    _subscribe(node, base_topic, transport, custom_qos, callback);
  }
  std::string getTopic() const {return rosward::resolve_name(_node, _topic, "topic");}
  std::string getInfoTopic() const {return rosward::resolve_name(_node, detail::camera_info(_topic), "topic");}
  size_t getNumPublishers() const {return rosward::unknown("live", "publishers of a topic", "int");}
  std::string getTransport() const {return _transport;}
  void shutdown() {}
  operator bool() const {return _node != nullptr;}
  template<typename NodeT, typename QosT, typename CallbackT>
  void _subscribe(
    const NodeT & node, const std::string & base_topic, const std::string & transport, const QosT & qos, const CallbackT & callback)
  {
    _node = rosward::interface_of(node);
    _topic = base_topic;
    _transport = transport;
    detail::subscribe(_node, base_topic, transport, qos, callback);
    rosward::create(
      "subscription", _node, detail::camera_info(base_topic), rosward::type<sensor_msgs::msg::CameraInfo>(), qos, callback);
    rclcpp::Subscription<sensor_msgs::msg::CameraInfo> of_info;
    of_info._node = _node;
    of_info._topic = detail::camera_info(base_topic);
    auto info = std::make_shared<sensor_msgs::msg::CameraInfo>();
    rclcpp::MessageInfo about;
    of_info.take(*info, about);
    rosward::schedule(callback, "message", rosward::arrived<sensor_msgs::msg::Image>(), info);
  }

  rosward::value _node;
  std::string _topic;
  std::string _transport;
};

template<typename NodeT, typename QosT = rclcpp::QoS>
[[rosward::creator]] Publisher create_publisher(
  NodeT node, const std::string & base_topic, const QosT & custom_qos = rmw_qos_profile_default,
  const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
{
  Publisher publisher;
  publisher._advertise(node, base_topic, custom_qos, options);
  return publisher;
}
template<typename NodeT, typename QosT = rclcpp::QoS>
[[rosward::creator]] CameraPublisher create_camera_publisher(
  NodeT node, const std::string & base_topic, const QosT & custom_qos = rmw_qos_profile_default,
  const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
{
  CameraPublisher publisher;
  publisher._advertise(node, base_topic, custom_qos, options);
  return publisher;
}
template<typename NodeT, typename CallbackT, typename QosT = rclcpp::QoS, typename... OptionsT>
[[rosward::creator]] Subscriber create_subscription(
  NodeT node, const std::string & base_topic, const CallbackT & callback, const std::string & transport = "raw",
  const QosT & custom_qos = rmw_qos_profile_default, const OptionsT & ... options)
{
  Subscriber subscriber;
  subscriber._subscribe(node, base_topic, transport, custom_qos, callback);
  return subscriber;
}
template<typename NodeT, typename CallbackT, typename QosT = rclcpp::QoS, typename... OptionsT>
[[rosward::creator]] CameraSubscriber create_camera_subscription(
  NodeT node, const std::string & base_topic, const CallbackT & callback, const std::string & transport = "raw",
  const QosT & custom_qos = rmw_qos_profile_default, const OptionsT & ... options)
{
  CameraSubscriber subscriber;
  subscriber._subscribe(node, base_topic, transport, custom_qos, callback);
  return subscriber;
}
std::vector<std::string> getDeclaredTransports() {return rosward::unknown("environment", "plugins of image_transport");}
std::vector<std::string> getLoadableTransports() {return rosward::unknown("environment", "plugins of image_transport");}
std::string getCameraInfoTopic(const std::string & base_topic) {return detail::camera_info(base_topic);}

class ImageTransport
{
public:
  template<typename NodeT>
  explicit ImageTransport(const NodeT & node) : _node(rosward::interface_of(node)) {}

  // A depth or a profile; then `latch`
  template<typename QosT, typename... LatchT>
  [[rosward::creator]] Publisher advertise(const std::string & base_topic, const QosT & qos, const LatchT & ... latch)
  {
    Publisher publisher;
    publisher._advertise(_node, base_topic, qos);
    return publisher;
  }
  template<typename QosT, typename... LatchT>
  [[rosward::creator]] CameraPublisher advertiseCamera(const std::string & base_topic, const QosT & qos, const LatchT & ... latch)
  {
    CameraPublisher publisher;
    publisher._advertise(_node, base_topic, qos);
    return publisher;
  }
  // Behind the callback: the object of a member function, or what is to live as long; hints; options
  template<typename QosT, typename CallbackT, typename... ArgsT>
  [[rosward::creator]] Subscriber subscribe(
    const std::string & base_topic, const QosT & qos, const CallbackT & callback, const ArgsT & ... args)
  {
    Subscriber subscriber;
    subscriber._subscribe(_node, base_topic, _hinted(args...), qos, rosward::bound(callback, args...));
    return subscriber;
  }
  template<typename QosT, typename CallbackT, typename... ArgsT>
  [[rosward::creator]] CameraSubscriber subscribeCamera(
    const std::string & base_topic, const QosT & qos, const CallbackT & callback, const ArgsT & ... args)
  {
    CameraSubscriber subscriber;
    subscriber._subscribe(_node, base_topic, _hinted(args...), qos, rosward::bound(callback, args...));
    return subscriber;
  }
  template<typename... ArgsT>
  std::string _hinted(const ArgsT & ... args) const
  {
    auto found = rosward::field_among("_transport", args...);
    return found == nullptr ? _node->get_parameter_or("image_transport", std::string("raw")) : found;
  }
  std::vector<std::string> getDeclaredTransports() const {return image_transport::getDeclaredTransports();}
  std::vector<std::string> getLoadableTransports() const {return image_transport::getLoadableTransports();}

  rosward::value _node;
};

class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::msg::Image>
{
public:
  SubscriberFilter() {}
  template<typename NodeT, typename... ArgsT>
  [[rosward::creator]] SubscriberFilter(
    NodeT node, const std::string & base_topic, const std::string & transport, const ArgsT & ... args)
  {
    subscribe(node, base_topic, transport, args...);
  }
  template<typename NodeT, typename QosT = rclcpp::QoS, typename... OptionsT>
  [[rosward::creator]] void subscribe(
    NodeT node, const std::string & base_topic, const std::string & transport,
    const QosT & qos = rmw_qos_profile_default, const OptionsT & ... options)
  {
    _subscriber._subscribe(node, base_topic, transport, qos, [](const sensor_msgs::msg::Image::ConstSharedPtr &) {});
  }
  void unsubscribe() {}
  std::string getTopic() const {return _subscriber.getTopic();}
  std::string getTransport() const {return _subscriber.getTransport();}
  const Subscriber & getSubscriber() const {return _subscriber;}

  Subscriber _subscriber;
};
}  // namespace image_transport
