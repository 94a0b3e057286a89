// SPDX-License-Identifier: Apache-2.0
// Actions: a server is asked for two goals, a client is answered; with contents, where it is observed.
#pragma once

#include <array>
#include <deque>
#include <future>
#include <memory>
#include <string>

#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp_action
{
using GoalUUID = std::array<uint8_t, 16>;
enum class GoalResponse : int8_t { REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3 };
enum class CancelResponse : int8_t { REJECT = 1, ACCEPT = 2 };
enum class ResultCode : int8_t { UNKNOWN = 0, SUCCEEDED = 4, CANCELED = 5, ABORTED = 6 };
inline std::string to_string(const GoalUUID &) { return "0"; }

template<typename ActionT>
class ServerGoalHandle
{
public:
  using Goal = typename ActionT::Goal;
  using Result = typename ActionT::Result;
  using Feedback = typename ActionT::Feedback;
  std::shared_ptr<const Goal> get_goal() const { return goal_; }
  const GoalUUID & get_goal_id() const { return id_; }
  bool is_canceling() const { return false; }
  bool is_active() const { return active_; }
  bool is_executing() const { return active_; }
  void execute() {}
  void publish_feedback(std::shared_ptr<Feedback> feedback) { rosward_double::leave("feedback:" + name_, *feedback); }
  void succeed(std::shared_ptr<Result> result) { end(*result); }
  void abort(std::shared_ptr<Result> result) { end(*result); }
  void canceled(std::shared_ptr<Result> result) { end(*result); }
  ServerGoalHandle() = default;
  ServerGoalHandle(const std::string & name, int turn) : name_(name)
  {
    auto goal = std::make_shared<Goal>();
    rosward_double::arrive("goal:" + name, turn, *goal);
    goal_ = goal;
  }

private:
  void end(const Result & result)
  {
    active_ = false;
    rosward_double::leave("result:" + name_, result);
  }
  std::string name_;
  std::shared_ptr<const Goal> goal_ = std::make_shared<Goal>();
  GoalUUID id_{};
  bool active_ = true;
};

class ServerBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<ServerBase>;
};

template<typename ActionT>
class Server : public ServerBase
{
public:
  using SharedPtr = std::shared_ptr<Server>;
  using Handle = ServerGoalHandle<ActionT>;
  using GoalCallback = std::function<GoalResponse(const GoalUUID &, std::shared_ptr<const typename ActionT::Goal>)>;
  using CancelCallback = std::function<CancelResponse(const std::shared_ptr<Handle>)>;
  using AcceptedCallback = std::function<void(std::shared_ptr<Handle>)>;
  Server(GoalCallback goal, CancelCallback cancel, AcceptedCallback accepted)
  : goal_(std::move(goal)), cancel_(std::move(cancel)), accepted_(std::move(accepted))
  {
  }
  bool serve() override
  {
    if (!turn()) {
      return false;
    }
    auto handle = std::make_shared<Handle>(name, turns());
    if (goal_(handle->get_goal_id(), handle->get_goal()) != GoalResponse::REJECT) {
      accepted_(handle);
      cancel_(handle);
    }
    return true;
  }
  std::string name;

private:
  GoalCallback goal_;
  CancelCallback cancel_;
  AcceptedCallback accepted_;
};

template<typename ActionT>
class ClientGoalHandle
{
public:
  using SharedPtr = std::shared_ptr<ClientGoalHandle>;
  struct WrappedResult
  {
    GoalUUID goal_id{};
    ResultCode code = ResultCode::SUCCEEDED;
    typename ActionT::Result::SharedPtr result = std::make_shared<typename ActionT::Result>();
  };
  const GoalUUID & get_goal_id() const { return id_; }
  int8_t get_status() const { return 4; }
  bool is_feedback_aware() const { return true; }
  bool is_result_aware() const { return true; }

private:
  GoalUUID id_{};
};

class ClientBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<ClientBase>;
  template<typename R = int64_t, typename P = std::milli>
  bool wait_for_action_server(std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
  {
    return true;
  }
  bool action_server_is_ready() const { return true; }
  bool serve() override
  {
    if (pending_.empty() || answered_ == 12) {
      return false;
    }
    auto answer = std::move(pending_.front());
    pending_.pop_front();
    answered_++;
    answer();
    return true;
  }

protected:
  std::deque<std::function<void()>> pending_;

private:
  int answered_ = 0;
};

template<typename ActionT>
class Client : public ClientBase
{
public:
  using SharedPtr = std::shared_ptr<Client>;
  using Goal = typename ActionT::Goal;
  using Feedback = typename ActionT::Feedback;
  using GoalHandle = ClientGoalHandle<ActionT>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  using GoalResponseCallback = std::function<void(typename GoalHandle::SharedPtr)>;
  using FeedbackCallback = std::function<void(typename GoalHandle::SharedPtr, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void(const WrappedResult &)>;
  using CancelResponse = action_msgs::srv::CancelGoal::Response;
  struct SendGoalOptions
  {
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    ResultCallback result_callback;
  };

  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    auto handle = std::make_shared<GoalHandle>();
    rosward_double::leave("goal:" + name, goal);
    pending_.push_back([this, promise, handle, options] {
        promise->set_value(handle);
        if (options.goal_response_callback) {
          options.goal_response_callback(handle);
        }
        if (options.feedback_callback) {
          auto feedback = std::make_shared<Feedback>();
          rosward_double::arrive("feedback:" + name, asked_, *feedback);
          options.feedback_callback(handle, feedback);
        }
        if (options.result_callback) {
          WrappedResult wrapped;
          rosward_double::arrive("result:" + name, asked_, *wrapped.result);
          options.result_callback(wrapped);
        }
        asked_++;
      });
    return promise->get_future().share();
  }
  std::shared_future<WrappedResult> async_get_result(typename GoalHandle::SharedPtr, ResultCallback callback = nullptr)
  {
    return later<WrappedResult>(std::move(callback));
  }
  std::shared_future<std::shared_ptr<CancelResponse>> async_cancel_goal(
    typename GoalHandle::SharedPtr, std::function<void(std::shared_ptr<CancelResponse>)> callback = nullptr)
  {
    return later<std::shared_ptr<CancelResponse>>(std::move(callback));
  }
  std::shared_future<std::shared_ptr<CancelResponse>> async_cancel_all_goals(std::function<void(std::shared_ptr<CancelResponse>)> callback = nullptr)
  {
    return later<std::shared_ptr<CancelResponse>>(std::move(callback));
  }
  std::string name;

private:
  int asked_ = 0;
  template<typename T, typename F>
  std::shared_future<T> later(F callback)
  {
    auto promise = std::make_shared<std::promise<T>>();
    pending_.push_back([promise, callback] {
        T value{};
        promise->set_value(value);
        if (callback) {
          callback(value);
        }
      });
    return promise->get_future().share();
  }
};

namespace detail
{
template<typename ActionT, typename ... Callbacks>
std::shared_ptr<Server<ActionT>> server(rosward_double::Core & node, const std::string & name, Callbacks && ... callbacks)
{
  auto made = std::make_shared<Server<ActionT>>(std::forward<Callbacks>(callbacks)...);
  made->name = node.create("as", name, rosidl_generator_traits::name<ActionT>());
  node.own(made);
  return made;
}
template<typename ActionT>
std::shared_ptr<Client<ActionT>> client(rosward_double::Core & node, const std::string & name)
{
  auto made = std::make_shared<Client<ActionT>>();
  made->name = node.create("ac", name, rosidl_generator_traits::name<ActionT>());
  node.own(made);
  return made;
}
}  // namespace detail

template<typename ActionT, typename NodeT, typename G, typename C, typename A>
std::shared_ptr<Server<ActionT>> create_server(
  NodeT && node, const std::string & name, G && goal, C && cancel, A && accepted, int = 0, rclcpp::CallbackGroup::SharedPtr = nullptr)
{
  return detail::server<ActionT>(*rosward_double::core_of(node), name, std::forward<G>(goal), std::forward<C>(cancel), std::forward<A>(accepted));
}
template<typename ActionT, typename G, typename C, typename A>
std::shared_ptr<Server<ActionT>> create_server(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, rclcpp::node_interfaces::NodeClockInterface::SharedPtr,
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr, rclcpp::node_interfaces::NodeWaitablesInterface::SharedPtr,
  const std::string & name, G && goal, C && cancel, A && accepted)
{
  return detail::server<ActionT>(*node->core(), name, std::forward<G>(goal), std::forward<C>(cancel), std::forward<A>(accepted));
}
template<typename ActionT, typename NodeT>
std::shared_ptr<Client<ActionT>> create_client(NodeT && node, const std::string & name, rclcpp::CallbackGroup::SharedPtr = nullptr)
{
  return detail::client<ActionT>(*rosward_double::core_of(node), name);
}
template<typename ActionT>
std::shared_ptr<Client<ActionT>> create_client(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, rclcpp::node_interfaces::NodeGraphInterface::SharedPtr,
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr, rclcpp::node_interfaces::NodeWaitablesInterface::SharedPtr,
  const std::string & name)
{
  return detail::client<ActionT>(*node->core(), name);
}
}  // namespace rclcpp_action
