// SPDX-License-Identifier: Apache-2.0
// interactive_markers: a server of markers publishes their updates, subscribes to what users do with them, and gives all of them.
//
// Read from ros-visualization/interactive_markers, branches humble and rolling (interactive_marker_server.hpp,
// src/interactive_marker_server.cpp).

namespace interactive_markers
{
namespace detail
{
// What is told of markers, or asked.
template<typename TargetT, typename... ContentT>
[[rosward::changes("target")]] void note(TargetT & target, const ContentT & ... content) {}
}  // namespace detail

class InteractiveMarkerServer
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(InteractiveMarkerServer)
  static const uint8_t DEFAULT_FEEDBACK_CB = 255;

  template<typename NodeT>
  [[rosward::creator]] InteractiveMarkerServer(const std::string & topic_namespace, NodeT node)
  {
    _serve(topic_namespace, node, rclcpp::QoS(100), rclcpp::QoS(1));
  }
  template<typename NodeT>
  [[rosward::creator]] InteractiveMarkerServer(
    const std::string & topic_namespace, NodeT node, const rclcpp::QoS & update_pub_qos,
    const rclcpp::QoS & feedback_sub_qos = rclcpp::QoS(1))
  {
    _serve(topic_namespace, node, update_pub_qos, feedback_sub_qos);
  }
  template<typename BaseT, typename ClockT, typename LoggingT, typename TopicsT, typename ServicesT>
  [[rosward::creator]] InteractiveMarkerServer(
    const std::string & topic_namespace, BaseT base_interface, ClockT clock_interface, LoggingT logging_interface,
    TopicsT topics_interface, ServicesT services_interface, const rclcpp::QoS & update_pub_qos = rclcpp::QoS(100),
    const rclcpp::QoS & feedback_sub_qos = rclcpp::QoS(1))
  {
    _serve(topic_namespace, topics_interface, update_pub_qos, feedback_sub_qos);
  }
  virtual ~InteractiveMarkerServer() {}

  template<typename MarkerT>
  void insert(const MarkerT & marker) {detail::note(_pending, marker);}
  template<typename MarkerT, typename CallbackT>
  void insert(const MarkerT & marker, const CallbackT & feedback_callback, uint8_t feedback_type = DEFAULT_FEEDBACK_CB)
  {
    insert(marker);
    setCallback("", feedback_callback);
  }
  template<typename CallbackT>
  bool setCallback(
    const std::string & name, const CallbackT & feedback_callback, uint8_t feedback_type = DEFAULT_FEEDBACK_CB)
  {
    rosward::schedule(
      feedback_callback, "message", rosward::arrived<visualization_msgs::msg::InteractiveMarkerFeedback>());
    return rosward::unknown("live", "markers", "bool");
  }
  template<typename... ArgsT>
  bool setPose(const ArgsT & ... args)
  {
    detail::note(_pending, args...);
    return rosward::unknown("live", "markers", "bool");
  }
  bool erase(const std::string & name)
  {
    detail::note(_pending, name);
    return rosward::unknown("live", "markers", "bool");
  }
  void clear() {}
  bool empty() const {return rosward::unknown("live", "markers", "bool");}
  std::size_t size() const {return rosward::unknown("live", "markers", "int");}
  void applyChanges()
  {
    rosward::send(
      "publication", _node, _update, rosward::type<visualization_msgs::msg::InteractiveMarkerUpdate>(), _pending);
    rosward::send(
      "response", _node, _service, rosward::type<visualization_msgs::srv::GetInteractiveMarkers::Response>(), _pending);
  }
  template<typename MarkerT>
  bool get(const std::string & name, MarkerT & marker) const
  {
    detail::note(marker, _pending, name);
    return rosward::unknown("live", "markers", "bool");
  }

  template<typename NodeT>
  void _serve(const std::string & topic_namespace, NodeT node, const rclcpp::QoS & update, const rclcpp::QoS & feedback)
  {
    auto found = rosward::interface_of(node);
    _node = found;
    _topic = topic_namespace + "/feedback";
    _update = topic_namespace + "/update";
    _service = topic_namespace + "/get_interactive_markers";
    rosward::create(
      "publisher", found, topic_namespace + "/update",
      rosward::type<visualization_msgs::msg::InteractiveMarkerUpdate>(), update);
    rosward::create(
      "service_server", found, topic_namespace + "/get_interactive_markers",
      rosward::type<visualization_msgs::srv::GetInteractiveMarkers>(), 10);
    rosward::create(
      "subscription", found, topic_namespace + "/feedback",
      rosward::type<visualization_msgs::msg::InteractiveMarkerFeedback>(), feedback);
    detail::note(_pending, *rosward::arrived<visualization_msgs::msg::InteractiveMarkerFeedback>());
  }

  rosward::value _node;
  std::string _topic;
  std::string _update;
  std::string _service;
  visualization_msgs::msg::InteractiveMarkerUpdate _pending;
};
}  // namespace interactive_markers
