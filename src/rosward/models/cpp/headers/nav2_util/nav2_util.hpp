// SPDX-License-Identifier: Apache-2.0
// nav2_util: the lifecycle nodes, clients and action servers of nav2, where its sources are not there.
//
// Read from ros-navigation/navigation2, branches humble to jazzy (nav2_util/include/nav2_util/*).

namespace nav2_util
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class LifecycleNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)
  explicit LifecycleNode(
    const std::string & node_name, const std::string & ns = "", const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : rclcpp_lifecycle::LifecycleNode(node_name, ns, options)
  {
    declare_parameter("/bond_disable_heartbeat_timeout", true);
    set_parameter(rclcpp::Parameter("/bond_disable_heartbeat_timeout", true));
  }
  virtual ~LifecycleNode() {}
  std::shared_ptr<LifecycleNode> shared_from_this() {return this;}
  void createBond() {bond_ = std::make_shared<bond::Bond>("bond", get_name(), this);}
  void destroyBond() {}
  nav2_util::CallbackReturn on_error(const rclcpp_lifecycle::State & state) override {return nav2_util::CallbackReturn::SUCCESS;}
  template<typename T, typename... ArgsT>
  void add_parameter(const std::string & name, const T & default_value, const ArgsT & ... args)
  {
    declare_parameter(name, default_value);
  }
  void runCleanups() {}
  void printLifecycleNodeNotification() {}

  std::shared_ptr<bond::Bond> bond_;
};

template<typename ServiceT, typename NodeT = rclcpp::Node::SharedPtr>
class ServiceClient
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceClient)
  using RequestType = typename ServiceT::Request;
  using ResponseType = typename ServiceT::Response;

  template<typename ProviderT>
  [[rosward::creator]] explicit ServiceClient(
    const std::string & service_name, const ProviderT & provided_node, bool use_internal_executor = false)
  {
    _client = rosward::node_behind(provided_node)->template create_client<ServiceT>(service_name);
  }
  template<typename... TimeoutT>
  auto invoke(std::shared_ptr<RequestType> & request, const TimeoutT & ... timeout)
  {
    return _client->async_send_request(request).get();
  }
  bool invoke(std::shared_ptr<RequestType> & request, std::shared_ptr<ResponseType> & response)
  {
    response = _client->async_send_request(request).get();
    return rosward::unknown("live", "whether an answer comes", "bool");
  }
  auto async_call(std::shared_ptr<RequestType> & request) {return _client->async_send_request(request);}
  template<typename CallbackT>
  void async_call(std::shared_ptr<RequestType> request, CallbackT && callback) {_client->async_send_request(request, callback);}
  template<typename... TimeoutT>
  bool wait_for_service(const TimeoutT & ... timeout) {return rosward::unknown("live", "whether a service is there", "bool");}
  std::string getServiceName() {return _client->get_service_name();}
  void stop() {}

  std::shared_ptr<rclcpp::Client<ServiceT>> _client;
};

template<typename ActionT>
class SimpleActionServer
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SimpleActionServer)
  template<typename NodeT, typename ExecuteT, typename... OthersT>
  [[rosward::creator]] explicit SimpleActionServer(
    NodeT node, const std::string & action_name, ExecuteT execute_callback, const OthersT & ... others)
  {
    _start(rosward::interface_of(node), action_name, execute_callback);
  }
  template<typename BaseT, typename ClockT, typename LoggingT, typename WaitablesT, typename ExecuteT, typename... OthersT>
  [[rosward::creator]] explicit SimpleActionServer(
    std::shared_ptr<BaseT> base, std::shared_ptr<ClockT> clock, std::shared_ptr<LoggingT> logging,
    std::shared_ptr<WaitablesT> waitables, const std::string & action_name, ExecuteT execute_callback, const OthersT & ... others)
  {
    _start(rosward::interface_of(base), action_name, execute_callback);
  }
  template<typename NodeT, typename ExecuteT>
  void _start(const NodeT & node, const std::string & action_name, ExecuteT & execute_callback)
  {
    rosward::create("action_server", node, action_name, rosward::type<ActionT>(), nullptr, execute_callback);
    rosward::schedule(execute_callback, "execute");
    _handle = std::make_shared<rclcpp_action::ServerGoalHandle<ActionT>>(node, action_name);
  }
  void activate() {}
  void deactivate() {}
  bool is_server_active() {return rosward::unknown("live", "state of an action server", "bool");}
  bool is_running() {return rosward::unknown("live", "state of an action server", "bool");}
  bool is_preempt_requested() const {return rosward::unknown("live", "state of an action server", "bool");}
  bool is_cancel_requested() const {return rosward::unknown("live", "state of an action server", "bool");}
  const std::shared_ptr<const typename ActionT::Goal> accept_pending_goal() {return _handle->get_goal();}
  void terminate_pending_goal() {}
  const std::shared_ptr<const typename ActionT::Goal> get_current_goal() const {return _handle->get_goal();}
  const rclcpp_action::GoalUUID get_current_goal_id() const {return _handle->get_goal_id();}
  const std::shared_ptr<const typename ActionT::Goal> get_pending_goal() const {return _handle->get_goal();}
  template<typename... ResultT>
  void terminate_all(const ResultT & ... result) {(_handle->abort(result), ...);}
  template<typename... ResultT>
  void terminate_current(const ResultT & ... result) {(_handle->abort(result), ...);}
  template<typename... ResultT>
  void succeeded_current(const ResultT & ... result) {(_handle->succeed(result), ...);}
  void publish_feedback(typename std::shared_ptr<typename ActionT::Feedback> feedback) {_handle->publish_feedback(feedback);}

  std::shared_ptr<rclcpp_action::ServerGoalHandle<ActionT>> _handle;
};

class LifecycleServiceClient
{
public:
  template<typename NodeT>
  [[rosward::creator]] LifecycleServiceClient(const std::string & lifecycle_node_name, NodeT parent_node)
  {
    auto node = rosward::interface_of(parent_node);
    _change = std::make_shared<rclcpp::detail::AskedService<lifecycle_msgs::srv::ChangeState>>(
      node, lifecycle_node_name + "/change_state", 10);
    _get = std::make_shared<rclcpp::detail::AskedService<lifecycle_msgs::srv::GetState>>(
      node, lifecycle_node_name + "/get_state", 10);
  }
  template<typename... ArgsT>
  bool change_state(const ArgsT & ... args) {return _change->ask(args...)->success;}
  template<typename... ArgsT>
  uint8_t get_state(const ArgsT & ... args) {return _get->ask()->current_state.id;}

  std::shared_ptr<rclcpp::detail::AskedService<lifecycle_msgs::srv::ChangeState>> _change;
  std::shared_ptr<rclcpp::detail::AskedService<lifecycle_msgs::srv::GetState>> _get;
};

class NodeThread
{
public:
  template<typename NodeT>
  explicit NodeThread(const NodeT & node) {rosward::spun(node);}
};

class OdomSmoother
{
public:
  template<typename NodeT>
  [[rosward::creator]] explicit OdomSmoother(
    const NodeT & parent, double filter_duration = 0.3, const std::string & odom_topic = "odom")
  : _node(rosward::interface_of(parent)), _topic(odom_topic)
  {
    rosward::create(
      "subscription", _node, _topic, rosward::type<nav_msgs::msg::Odometry>(), rclcpp::SystemDefaultsQoS());
  }
  geometry_msgs::msg::Twist getTwist() {return rosward::message<geometry_msgs::msg::Twist>();}
  geometry_msgs::msg::TwistStamped getTwistStamped() {return rosward::message<geometry_msgs::msg::TwistStamped>();}

  rosward::value _node;
  std::string _topic;
};

template<typename NodeT, typename DefaultT, typename... DescriptorT>
void declare_parameter_if_not_declared(
  NodeT node, const std::string & parameter_name, const DefaultT & default_value, const DescriptorT & ... descriptor)
{
  if (!node->has_parameter(parameter_name)) {
    node->declare_parameter(parameter_name, default_value, descriptor...);
  }
}
template<typename ParameterT, typename NodeT>
ParameterT declare_or_get_parameter(NodeT node, const std::string & parameter_name, const ParameterT & default_value)
{
  declare_parameter_if_not_declared(node, parameter_name, default_value);
  return node->get_parameter(parameter_name).template get_value<ParameterT>();
}
template<typename NodeT>
std::string get_plugin_type_param(NodeT node, const std::string & plugin_name)
{
  declare_parameter_if_not_declared(node, plugin_name + ".plugin", rclcpp::PARAMETER_STRING);
  return node->get_parameter(plugin_name + ".plugin").as_string();
}
std::string sanitize_node_name(const std::string & potential_node_name)
{
  std::string node_name(potential_node_name);
  std::replace_if(begin(node_name), end(node_name), [](auto c) {return !isalnum(c);}, '_');
  return node_name;
}
std::string add_namespaces(const std::string & top_ns, const std::string & sub_ns = "")
{
  if (!top_ns.empty() && top_ns.back() == '/') {
    return (top_ns.front() == '/' ? top_ns : "/" + top_ns) + sub_ns;
  }
  return top_ns + "/" + sub_ns;
}
[[rosward::source("clock")]] std::string time_to_string(size_t len) {return rosward::unknown("random", "time", "str");}
std::string generate_internal_node_name(const std::string & prefix = "")
{
  return sanitize_node_name(prefix) + "_" + time_to_string(8);
}
rclcpp::Node::SharedPtr generate_internal_node(const std::string & prefix = "")
{
  auto options = rclcpp::NodeOptions()
    .start_parameter_services(false)
    .start_parameter_event_publisher(false)
    .arguments({"--ros-args", "-r", "__node:=" + generate_internal_node_name(prefix), "--"});
  return rclcpp::Node::make_shared("_", options);
}
void setSoftRealTimePriority() {}
template<typename... ArgsT>
[[rosward::source("tf"), rosward::changes("global_pose")]] bool getCurrentPose(geometry_msgs::msg::PoseStamped & global_pose, const ArgsT & ... args)
{
  rosward::fill(global_pose);
  return rosward::unknown("live", "whether a transform is there", "bool");
}
template<typename InT, typename OutT, typename... ArgsT>
[[rosward::source("tf"), rosward::changes("transformed_pose")]] bool transformPoseInTargetFrame(const InT & input_pose, OutT & transformed_pose, const ArgsT & ... args)
{
  rosward::fill(transformed_pose);
  return rosward::unknown("live", "whether a transform is there", "bool");
}
std::string strip_leading_slash(const std::string & in)
{
  return !in.empty() && in[0] == '/' ? in.substr(1) : in;
}
}  // namespace nav2_util
