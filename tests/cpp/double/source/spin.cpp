// SPDX-License-Identifier: Apache-2.0
// How programs begin, spin and end.
#include <dirent.h>

#include <atomic>

#include "rclcpp/rclcpp.hpp"

namespace rosward_double
{
namespace
{
Arguments arguments;
std::atomic<bool> over{false};
std::atomic<int> turns{0};
std::vector<std::function<void()>> at_end;

int threads()
{
  int count = 0;
  if (DIR * folder = opendir("/proc/self/task")) {
    while (readdir(folder)) {
      count++;
    }
    closedir(folder);
  }
  return count - 2;
}
}  // namespace

const Arguments & global_arguments() { return arguments; }
void start(const std::vector<std::string> & words)
{
  arguments = read_arguments(words);
  over = false;
}

// A program that asks again and again is told at some time that it is over.
bool ok() { return !over && ++turns < 200; }

void ended()
{
  if (!over.exchange(true)) {
    const auto callbacks = std::move(at_end);
    for (const auto & callback : callbacks) {
      callback();
    }
  }
}

void settle()
{
  for (int i = 0; i < 100 && threads() > 1; i++) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void spin(const std::vector<std::shared_ptr<Core>> & nodes, int rounds)
{
  turns += 20;
  bool called = true;
  for (int round = 0; round < rounds && called; round++) {
    called = false;
    for (const auto & node : nodes) {
      if (node->transitions) {
        node->transitions(false);
      }
      called = node->serve() || called;
    }
    if (called && rounds > 1) {
      settle();
    }
  }
}

void finish(const std::vector<std::shared_ptr<Core>> & nodes)
{
  spin(nodes, 8);
  for (const auto & node : nodes) {
    if (node->transitions) {
      node->transitions(true);
    }
  }
  ended();
}
}  // namespace rosward_double

namespace rclcpp
{
void Context::init(int argc, char const * const * argv, const InitOptions &) { rclcpp::init(argc, argv); }
bool Context::is_valid() const { return rosward_double::ok(); }
bool Context::shutdown(const std::string &)
{
  rosward_double::ended();
  return true;
}
std::shared_ptr<Context> contexts::get_global_default_context()
{
  static const auto context = std::make_shared<Context>();
  return context;
}

void init(int argc, char const * const * argv, const InitOptions &, SignalHandlerOptions)
{
  rosward_double::start(argv == nullptr ? std::vector<std::string>() : std::vector<std::string>(argv, argv + argc));
}
std::vector<std::string> init_and_remove_ros_arguments(int argc, char const * const * argv, const InitOptions &)
{
  init(argc, argv);
  return remove_ros_arguments(argc, argv);
}
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  return rosward_double::read_arguments(std::vector<std::string>(argv, argv + argc)).others;
}
bool ok(std::shared_ptr<Context>) { return rosward_double::ok(); }
bool shutdown(std::shared_ptr<Context>, const std::string &)
{
  rosward_double::ended();
  return true;
}
bool install_signal_handlers() { return true; }
bool uninstall_signal_handlers() { return true; }
bool sleep_for(const std::chrono::nanoseconds &, std::shared_ptr<Context>) { return rosward_double::ok(); }
void on_shutdown(std::function<void()> callback, std::shared_ptr<Context>) { rosward_double::at_end.push_back(std::move(callback)); }

std::string to_string(const FutureReturnCode & code) { return code == FutureReturnCode::SUCCESS ? "SUCCESS (0)" : "TIMEOUT (2)"; }

std::vector<std::shared_ptr<rosward_double::Core>> Executor::there() const
{
  std::vector<std::shared_ptr<rosward_double::Core>> found;
  for (const auto & each : nodes_) {
    if (auto node = each.lock()) {
      found.push_back(node);
    }
  }
  return found;
}
void Executor::spin() { rosward_double::finish(there()); }
void Executor::once() { rosward_double::spin(there(), 1); }

void spin(node_interfaces::NodeBaseInterface::SharedPtr node) { rosward_double::finish({node->core()}); }
void spin(std::shared_ptr<Node> node) { rosward_double::finish({node->core()}); }
void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node) { rosward_double::spin({node->core()}, 1); }
void spin_some(std::shared_ptr<Node> node) { rosward_double::spin({node->core()}, 1); }
void spin_all(node_interfaces::NodeBaseInterface::SharedPtr node, std::chrono::nanoseconds) { rosward_double::spin({node->core()}, 1); }
void spin_all(std::shared_ptr<Node> node, std::chrono::nanoseconds) { rosward_double::spin({node->core()}, 1); }
}  // namespace rclcpp
