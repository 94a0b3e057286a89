// SPDX-License-Identifier: Apache-2.0
// Spinning: everything is called, then it returns.
#pragma once

#include <future>
#include <memory>
#include <vector>

#include "rclcpp/node.hpp"

namespace rclcpp
{
enum class FutureReturnCode { SUCCESS, INTERRUPTED, TIMEOUT };
std::string to_string(const FutureReturnCode & code);

class GuardCondition
{
public:
  using SharedPtr = std::shared_ptr<GuardCondition>;
  explicit GuardCondition(std::shared_ptr<Context> = nullptr) {}
  void trigger() {}
};
struct ExecutorOptions
{
  std::shared_ptr<Context> context;
};

class Executor
{
public:
  using SharedPtr = std::shared_ptr<Executor>;
  explicit Executor(const ExecutorOptions & = {}, size_t = 0, bool = false) {}
  virtual ~Executor() = default;
  template<typename N>
  void add_node(N && node, bool = true)
  {
    nodes_.push_back(rosward_double::core_of(node));
  }
  template<typename N>
  void remove_node(N && node, bool = true)
  {
    const auto gone = rosward_double::core_of(node);
    std::vector<std::weak_ptr<rosward_double::Core>> kept;
    for (const auto & each : nodes_) {
      if (each.lock() != gone) {
        kept.push_back(each);
      }
    }
    nodes_ = kept;
  }
  template<typename B>
  void add_callback_group(CallbackGroup::SharedPtr, B && node, bool = true)
  {
    add_node(node);
  }
  virtual void spin();
  void spin_some(std::chrono::nanoseconds = {}) { once(); }
  void spin_all(std::chrono::nanoseconds) { once(); }
  void spin_once(std::chrono::nanoseconds = {}) { once(); }
  template<typename N>
  void spin_node_some(N && node)
  {
    add_node(node);
    once();
    remove_node(node);
  }
  template<typename FutureT, typename R = int64_t, typename P = std::milli>
  FutureReturnCode spin_until_future_complete(const FutureT & future, std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
  {
    for (int round = 0; round < 8; round++) {
      if (future.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        return FutureReturnCode::SUCCESS;
      }
      once();
    }
    return FutureReturnCode::TIMEOUT;
  }
  void cancel() {}
  bool is_spinning() const { return false; }

private:
  void once();
  std::vector<std::shared_ptr<rosward_double::Core>> there() const;
  std::vector<std::weak_ptr<rosward_double::Core>> nodes_;
};

namespace executors
{
class SingleThreadedExecutor : public Executor
{
public:
  using SharedPtr = std::shared_ptr<SingleThreadedExecutor>;
  using Executor::Executor;
};
class MultiThreadedExecutor : public Executor
{
public:
  using SharedPtr = std::shared_ptr<MultiThreadedExecutor>;
  using Executor::Executor;
  size_t get_number_of_threads() const { return 2; }
};
class StaticSingleThreadedExecutor : public Executor
{
public:
  using Executor::Executor;
};
using FutureReturnCode = rclcpp::FutureReturnCode;
}  // namespace executors
namespace experimental::executors
{
using EventsExecutor = rclcpp::executors::SingleThreadedExecutor;
}

void spin(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin(std::shared_ptr<Node> node);
void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node);
void spin_some(std::shared_ptr<Node> node);
void spin_all(node_interfaces::NodeBaseInterface::SharedPtr node, std::chrono::nanoseconds);
void spin_all(std::shared_ptr<Node> node, std::chrono::nanoseconds);
template<typename N, typename FutureT, typename R = int64_t, typename P = std::milli>
FutureReturnCode spin_until_future_complete(N node, const FutureT & future, std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
{
  Executor executor;
  executor.add_node(node);
  return executor.spin_until_future_complete(future);
}
}  // namespace rclcpp
