// SPDX-License-Identifier: Apache-2.0
// rclcpp: where does what is scheduled run? Executors, `spin*`, wait sets. Callbacks are taken to run of all nodes that there are.
//
// Read from rclcpp, branches humble, jazzy and rolling (executor.hpp, executors.hpp, executors/*, experimental/executors/*, wait_set_template.hpp).

namespace rclcpp
{
class Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Executor)
  explicit Executor(const ExecutorOptions & options = ExecutorOptions()) {}
  virtual ~Executor() {}
  virtual void spin() {rosward::spin();}
  template<typename NodeT>
  void add_node(NodeT node, bool notify = true) {rosward::spun(node);}
  template<typename NodeT>
  void remove_node(NodeT node, bool notify = true) {}
  template<typename NodeT>
  void add_callback_group(CallbackGroup::SharedPtr group, NodeT node, bool notify = true) {rosward::spun(node);}
  virtual void remove_callback_group(CallbackGroup::SharedPtr group, bool notify = true) {}
  virtual std::vector<CallbackGroup::WeakPtr> get_all_callback_groups();
  template<typename NodeT, typename TimeoutT = int>
  void spin_node_once(NodeT node, const TimeoutT & timeout = -1)
  {
    rosward::spun(node);
    rosward::spin();
  }
  template<typename NodeT>
  void spin_node_some(NodeT node)
  {
    rosward::spun(node);
    rosward::spin();
  }
  template<typename NodeT, typename TimeoutT = int>
  void spin_node_all(NodeT node, const TimeoutT & timeout = -1)
  {
    rosward::spun(node);
    rosward::spin();
  }
  template<typename TimeoutT = int>
  void spin_some(const TimeoutT & max_duration = 0) {rosward::spin();}
  template<typename TimeoutT = int>
  void spin_all(const TimeoutT & max_duration = 0) {rosward::spin();}
  template<typename TimeoutT = int>
  void spin_once(const TimeoutT & timeout = -1) {rosward::spin();}
  template<typename FutureT, typename TimeoutT = int>
  FutureReturnCode spin_until_future_complete(const FutureT & future, const TimeoutT & timeout = -1)
  {
    rosward::spin();
    return rosward::unknown("live", "whether an answer comes");
  }
  template<typename FutureT, typename TimeoutT = int>
  FutureReturnCode spin_until_complete(const FutureT & future, const TimeoutT & timeout = -1)
  {
    rosward::spin();
    return rosward::unknown("live", "whether an answer comes");
  }
  virtual void cancel() {}
  bool is_spinning();
};

namespace executors
{
class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  explicit SingleThreadedExecutor(const ExecutorOptions & options = ExecutorOptions()) {}
};
class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  template<typename... ArgsT>
  explicit MultiThreadedExecutor(const ArgsT & ... args) {}
  size_t get_number_of_threads();
};
class StaticSingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  explicit StaticSingleThreadedExecutor(const ExecutorOptions & options = ExecutorOptions()) {}
};

template<typename ExecutorT, typename NodeT, typename FutureT, typename TimeoutT = int>
FutureReturnCode spin_node_until_future_complete(
  ExecutorT & executor, NodeT node, const FutureT & future, const TimeoutT & timeout = -1)
{
  rosward::spun(node);
  rosward::spin();
  return rosward::unknown("live", "whether an answer comes");
}
}  // namespace executors

namespace experimental
{
namespace executors
{
class EventsExecutor : public rclcpp::Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)
  template<typename... ArgsT>
  explicit EventsExecutor(const ArgsT & ... args) {}
};
}  // namespace executors
}  // namespace experimental

template<typename NodeT>
void spin(NodeT node)
{
  rosward::spun(node);
  rosward::spin();
}
template<typename NodeT>
void spin_some(NodeT node)
{
  rosward::spun(node);
  rosward::spin();
}
template<typename NodeT, typename TimeoutT = int>
void spin_all(NodeT node, const TimeoutT & max_duration = 0)
{
  rosward::spun(node);
  rosward::spin();
}
template<typename NodeT, typename TimeoutT = int>
void spin_once(NodeT node, const TimeoutT & max_duration = 0)
{
  rosward::spun(node);
  rosward::spin();
}
template<typename NodeT, typename FutureT, typename TimeoutT = int>
FutureReturnCode spin_until_future_complete(NodeT node, const FutureT & future, const TimeoutT & timeout = -1)
{
  rosward::spun(node);
  rosward::spin();
  return rosward::unknown("live", "whether an answer comes");
}

enum WaitResultKind { Ready, Timeout, Empty, Invalid };

class WaitSet
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSet)
  template<typename... ArgsT>
  explicit WaitSet(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_subscription(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_subscription(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_timer(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_timer(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_client(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_client(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_service(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_service(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_guard_condition(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_guard_condition(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void add_waitable(const ArgsT & ... args) {}
  template<typename... ArgsT>
  void remove_waitable(const ArgsT & ... args) {}
  template<typename... ArgsT>
  auto wait(const ArgsT & ... args)
  {
    rosward::spin();
    return rosward::unknown("live", "what is ready");
  }
  template<typename... ArgsT>
  void prune_deleted_entities(const ArgsT & ... args) {}
};
using StaticWaitSet = WaitSet;
using ThreadSafeWaitSet = WaitSet;
}  // namespace rclcpp
