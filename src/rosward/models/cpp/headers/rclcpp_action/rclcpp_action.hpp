// SPDX-License-Identifier: Apache-2.0
// rclcpp_action: goals, their acceptance, execution and cancelling may come at any time.
//
// Read from rclcpp_action, branches humble, jazzy and rolling (server.hpp, server_goal_handle.hpp, client.hpp, client_goal_handle.hpp, types.hpp,
// create_server.hpp, create_client.hpp).

namespace rclcpp_action
{
using GoalUUID = std::array<uint8_t, 16>;
using GoalID = GoalUUID;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;
using CancelRequest = action_msgs::srv::CancelGoal::Request;
using CancelResponseMessage = action_msgs::srv::CancelGoal::Response;

enum class GoalResponse { REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3 };
enum class CancelResponse { REJECT = 1, ACCEPT = 2 };
enum class ResultCode { UNKNOWN = 0, SUCCEEDED = 4, CANCELED = 5, ABORTED = 6 };

std::string to_string(const GoalUUID & goal_id) {return rosward::unknown("message", "goal id", "str");}
void convert(const GoalUUID & goal_id, rcl_action_goal_info_t * info) {}

namespace exceptions
{
class UnawareGoalHandleError : public std::runtime_error
{
public:
  UnawareGoalHandleError(const std::string & message = "") : std::runtime_error(message) {}
};
class UnknownGoalHandleError : public std::invalid_argument
{
public:
  UnknownGoalHandleError(const std::string & message = "") : std::invalid_argument(message) {}
};
}  // namespace exceptions

class ServerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerBase)
  virtual ~ServerBase() {}
  void publish_status() {}
  void notify_goal_terminal_state() {}

  rclcpp::AnyNode * _node = nullptr;
  std::string _action;
};

template<typename ActionT>
class ServerGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServerGoalHandle)
  ServerGoalHandle() {}
  ServerGoalHandle(rclcpp::AnyNode * node, const std::string & action)
  : _node(node), _action(action), _goal(rosward::arrived<typename ActionT::Goal>()) {}

  const std::shared_ptr<const typename ActionT::Goal> get_goal() const {return _goal;}
  const GoalUUID & get_goal_id() const {return rosward::unknown("message", "goal id");}
  bool is_canceling() const {return rosward::unknown("message", "state of the goal", "bool");}
  bool is_active() const {return rosward::unknown("message", "state of the goal", "bool");}
  bool is_executing() const {return rosward::unknown("message", "state of the goal", "bool");}
  bool try_canceling() {return rosward::unknown("message", "state of the goal", "bool");}
  void execute() {}
  void publish_feedback(std::shared_ptr<typename ActionT::Feedback> feedback)
  {
    rosward::send("feedback", _node, _action, rosward::type<typename ActionT::Feedback>(), feedback);
  }
  void succeed(std::shared_ptr<typename ActionT::Result> result) {_end(result);}
  void abort(std::shared_ptr<typename ActionT::Result> result) {_end(result);}
  void canceled(std::shared_ptr<typename ActionT::Result> result) {_end(result);}
  void _end(std::shared_ptr<typename ActionT::Result> result)
  {
    rosward::send("result", _node, _action, rosward::type<typename ActionT::Result>(), result);
  }

  rclcpp::AnyNode * _node = nullptr;
  std::string _action;
  std::shared_ptr<const typename ActionT::Goal> _goal;
};

template<typename ActionT>
class Server : public ServerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Server)
  using GoalCallback = std::function<GoalResponse(const GoalUUID &, std::shared_ptr<const typename ActionT::Goal>)>;
  using CancelCallback = std::function<CancelResponse(std::shared_ptr<ServerGoalHandle<ActionT>>)>;
  using AcceptedCallback = std::function<void(std::shared_ptr<ServerGoalHandle<ActionT>>)>;
  Server() {}
  void configure_introspection(rclcpp::Clock::SharedPtr clock, const rclcpp::QoS & qos, rcl_service_introspection_state_t state)
  {
    if (state != RCL_SERVICE_INTROSPECTION_OFF) {
      rosward::introspect("action_server", _node, _action, rosward::type<ActionT>(), qos);
    }
  }
};

template<typename ActionT>
class ClientGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientGoalHandle)
  struct WrappedResult
  {
    GoalUUID goal_id;
    ResultCode code = rosward::unknown("message", "state of the goal", "int");
    std::shared_ptr<typename ActionT::Result> result = rosward::arrived<typename ActionT::Result>();
  };
  using Feedback = typename ActionT::Feedback;
  using Result = WrappedResult;
  using FeedbackCallback =
    std::function<void(std::shared_ptr<ClientGoalHandle<ActionT>>, std::shared_ptr<const typename ActionT::Feedback>)>;
  using ResultCallback = std::function<void(const WrappedResult & result)>;

  const GoalUUID & get_goal_id() const {return rosward::unknown("message", "goal id");}
  auto get_goal_stamp() const {return rclcpp::Time();}
  int8_t get_status() {return rosward::unknown("message", "state of the goal", "int");}
  bool is_feedback_aware() {return true;}
  bool is_result_aware() {return true;}
  auto async_get_result() {return rclcpp::detail::Future<WrappedResult>(WrappedResult());}
  auto async_result() {return rclcpp::detail::Future<WrappedResult>(WrappedResult());}
};

class ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)
  virtual ~ClientBase() {}
  bool action_server_is_ready() const {return rosward::unknown("live", "whether an action server is there", "bool");}
  template<typename TimeoutT = int>
  bool wait_for_action_server(const TimeoutT & timeout = -1)
  {
    return rosward::unknown("live", "whether an action server is there", "bool");
  }

  rclcpp::AnyNode * _node = nullptr;
  std::string _action;
};

template<typename ActionT>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Goal = typename ActionT::Goal;
  using Feedback = typename ActionT::Feedback;
  using GoalHandle = ClientGoalHandle<ActionT>;
  using WrappedResult = typename ClientGoalHandle<ActionT>::WrappedResult;
  using GoalResponseCallback = std::function<void(std::shared_ptr<ClientGoalHandle<ActionT>>)>;
  using FeedbackCallback =
    std::function<void(std::shared_ptr<ClientGoalHandle<ActionT>>, std::shared_ptr<const typename ActionT::Feedback>)>;
  using ResultCallback = std::function<void(const WrappedResult & result)>;
  using CancelRequest = action_msgs::srv::CancelGoal::Request;
  using CancelResponse = action_msgs::srv::CancelGoal::Response;
  using CancelCallback = std::function<void(std::shared_ptr<action_msgs::srv::CancelGoal::Response>)>;

  void configure_introspection(rclcpp::Clock::SharedPtr clock, const rclcpp::QoS & qos, rcl_service_introspection_state_t state)
  {
    if (state != RCL_SERVICE_INTROSPECTION_OFF) {
      rosward::introspect("action_client", _node, _action, rosward::type<ActionT>(), qos);
    }
  }

  struct SendGoalOptions
  {
    std::function<void(std::shared_ptr<ClientGoalHandle<ActionT>>)> goal_response_callback;
    std::function<void(std::shared_ptr<ClientGoalHandle<ActionT>>, std::shared_ptr<const typename ActionT::Feedback>)>
    feedback_callback;
    std::function<void(const typename ClientGoalHandle<ActionT>::WrappedResult & result)> result_callback;
  };

  Client() {}

  auto async_send_goal(const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    rosward::send("goal", _node, _action, rosward::type<Goal>(), goal);
    auto handle = std::make_shared<ClientGoalHandle<ActionT>>();
    if (rosward::takes(options.goal_response_callback, "shared_future")) {
      rosward::schedule(
        options.goal_response_callback, "goal response",
        rclcpp::detail::Future<std::shared_ptr<ClientGoalHandle<ActionT>>>(handle));
    } else {
      rosward::schedule(options.goal_response_callback, "goal response", rosward::either(handle, nullptr));
    }
    rosward::schedule(options.feedback_callback, "feedback", handle, rosward::arrived<Feedback>());
    rosward::schedule(options.result_callback, "result", WrappedResult());
    return rclcpp::detail::Future<std::shared_ptr<ClientGoalHandle<ActionT>>>(handle);
  }
  template<typename... ArgsT>
  auto async_get_result(std::shared_ptr<ClientGoalHandle<ActionT>> goal_handle, const ArgsT & ... callback)
  {
    (rosward::schedule(callback, "result", WrappedResult()), ...);
    return rclcpp::detail::Future<WrappedResult>(WrappedResult());
  }
  template<typename... ArgsT>
  auto async_cancel_goal(std::shared_ptr<ClientGoalHandle<ActionT>> goal_handle, const ArgsT & ... callback)
  {
    return _canceled(callback...);
  }
  template<typename... ArgsT>
  auto async_cancel_all_goals(const ArgsT & ... callback) {return _canceled(callback...);}
  template<typename TimeT, typename... ArgsT>
  auto async_cancel_goals_before(const TimeT & stamp, const ArgsT & ... callback) {return _canceled(callback...);}
  template<typename... ArgsT>
  auto _canceled(const ArgsT & ... callback)
  {
    rosward::send("cancel", _node, _action, rosward::type<ActionT>(), 0);
    (rosward::schedule(callback, "response", rosward::arrived<action_msgs::srv::CancelGoal::Response>()), ...);
    return rclcpp::detail::Future<std::shared_ptr<action_msgs::srv::CancelGoal::Response>>(
      rosward::arrived<action_msgs::srv::CancelGoal::Response>());
  }
  void stop_callbacks(std::shared_ptr<ClientGoalHandle<ActionT>> goal_handle) {}
};

namespace detail
{
template<typename ActionT, typename GoalT, typename CancelT, typename AcceptedT>
std::shared_ptr<Server<ActionT>> make_server(
  rclcpp::AnyNode * node, const std::string & name, GoalT & handle_goal, CancelT & handle_cancel, AcceptedT & handle_accepted)
{
  rosward::create("action_server", node, name, rosward::type<ActionT>(), nullptr, handle_accepted);
  auto server = std::make_shared<Server<ActionT>>();
  server->_node = node;
  server->_action = name;
  auto handle = std::make_shared<ServerGoalHandle<ActionT>>(node, name);
  rosward::schedule(handle_goal, "goal", GoalUUID(), handle->get_goal());
  rosward::schedule(handle_cancel, "cancel", handle);
  rosward::schedule(handle_accepted, "accepted", handle);
  return server;
}
template<typename ActionT>
std::shared_ptr<Client<ActionT>> make_client(rclcpp::AnyNode * node, const std::string & name)
{
  rosward::create("action_client", node, name, rosward::type<ActionT>());
  auto client = std::make_shared<Client<ActionT>>();
  client->_node = node;
  client->_action = name;
  return client;
}
}  // namespace detail

template<typename ActionT, typename NodeT, typename GoalT, typename CancelT, typename AcceptedT, typename OptionsT = int>
[[rosward::creator]] std::shared_ptr<Server<ActionT>> create_server(
  NodeT node, const std::string & name, GoalT handle_goal, CancelT handle_cancel, AcceptedT handle_accepted,
  const OptionsT & options = 0, rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return detail::make_server<ActionT>(rosward::interface_of(node), name, handle_goal, handle_cancel, handle_accepted);
}
template<typename ActionT, typename BaseT, typename ClockT, typename LoggingT, typename WaitablesT, typename GoalT, typename CancelT,
  typename AcceptedT, typename OptionsT = int>
[[rosward::creator]] std::shared_ptr<Server<ActionT>> create_server(
  BaseT node_base, ClockT node_clock, LoggingT node_logging, WaitablesT node_waitables, const std::string & name,
  GoalT handle_goal, CancelT handle_cancel, AcceptedT handle_accepted, const OptionsT & options = 0,
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return detail::make_server<ActionT>(rosward::interface_of(node_base), name, handle_goal, handle_cancel, handle_accepted);
}
template<typename ActionT, typename NodeT, typename OptionsT = int>
[[rosward::creator]] std::shared_ptr<Client<ActionT>> create_client(
  NodeT node, const std::string & name, rclcpp::CallbackGroup::SharedPtr group = nullptr, const OptionsT & options = 0)
{
  return detail::make_client<ActionT>(rosward::interface_of(node), name);
}
template<typename ActionT, typename BaseT, typename GraphT, typename LoggingT, typename WaitablesT, typename OptionsT = int>
[[rosward::creator]] std::shared_ptr<Client<ActionT>> create_client(
  BaseT node_base, GraphT node_graph, LoggingT node_logging, WaitablesT node_waitables, const std::string & name,
  rclcpp::CallbackGroup::SharedPtr group = nullptr, const OptionsT & options = 0)
{
  return detail::make_client<ActionT>(rosward::interface_of(node_base), name);
}
}  // namespace rclcpp_action
