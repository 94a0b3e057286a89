// SPDX-License-Identifier: Apache-2.0
// What a node is, behind all that a program sees of it: its names, its parameters, and what spinning calls.
//
// Each creation is one line of the standard output:  @double pub /cell/n1 /cell/out std_msgs/msg/String
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rclcpp
{
class Parameter;
class ParameterValue;
class NodeOptions;
}  // namespace rclcpp

namespace rosward_double
{
bool observed();  // contents.hpp

// Something of a node that spinning serves: `serve` says whether a function of the program was called.
class Entity
{
public:
  virtual ~Entity() = default;
  virtual bool serve() { return false; }

protected:
  // Each callback is called twice in the life of a program, and more often where it is observed.
  bool turn() { return turns_++ < (observed() ? 4 : 2); }
  int turns() const { return turns_; }

private:
  int turns_ = 0;
};

struct RemapRule
{
  std::string node, scope, from, to;
};

struct ParameterRule
{
  std::string node, name, value;
};

// What a command line says to nodes, and what it leaves to the program.
struct Arguments
{
  std::vector<RemapRule> remaps;
  std::vector<ParameterRule> parameters;
  std::vector<std::string> others;
};

Arguments read_arguments(const std::vector<std::string> & words);

struct Parameters;  // source/parameters.cpp

class Core : public std::enable_shared_from_this<Core>
{
public:
  Core(const std::string & name, const std::string & space, const rclcpp::NodeOptions & options);
  ~Core();

  const std::string & name() const { return name_; }
  const std::string & space() const { return space_; }
  const std::string & full_name() const { return full_name_; }

  // The final name of a topic or service; throws as rclcpp does.
  std::string resolve(const std::string & name, bool service, bool remap = true) const;
  // Notes a creation, and gives the final name.
  std::string create(const char * kind, const std::string & name, const std::string & type);
  void system(const char * kind, const std::string & full_name, const char * type);
  void own(const std::shared_ptr<Entity> & entity);

  // Calls what the entities have to call, once; whether there was anything.
  bool serve();
  std::function<void(bool finish)> transitions;  // of a lifecycle node

  std::unique_ptr<Parameters> parameters;
  bool statistics = false;  // of all subscriptions that do not say otherwise

private:
  friend struct Parameters;
  std::vector<RemapRule> remaps_;
  std::string name_, space_, full_name_;
  std::recursive_mutex mutex_;
  std::vector<std::weak_ptr<Entity>> entities_;
  bool clock_ = false;
  int rounds_ = 0;

public:
  void follow_clock();  // use_sim_time is true
};

void log(const std::string & line);

// The nodes are spun till nothing is left to call; `rounds` for those that return early.
void spin(const std::vector<std::shared_ptr<Core>> & nodes, int rounds);
void finish(const std::vector<std::shared_ptr<Core>> & nodes);
void settle();  // waits, for a short time, till the program's further threads have ended
bool ok();
void ended();
void start(const std::vector<std::string> & words);
const Arguments & global_arguments();

using Factory = std::function<std::shared_ptr<void>(const rclcpp::NodeOptions &)>;
int register_component(const char * name, Factory factory);
void component(const std::shared_ptr<Core> & node);

// Whatever stands for a node: a node, its interfaces, a pointer to one of these.
template<typename T>
auto core_of(T && node) -> decltype(node.core())
{
  return node.core();
}
template<typename T>
auto core_of(T && node) -> decltype((*node).core())
{
  return (*node).core();
}
template<typename T>
auto has_arrow(int) -> decltype(std::declval<T>().operator->(), std::true_type());
template<typename T>
std::false_type has_arrow(...);
// The node behind a pointer, or itself.
template<typename T>
decltype(auto) pointed(T && node)
{
  if constexpr (std::is_class_v<std::remove_reference_t<T>> && !std::is_same_v<decltype(has_arrow<T>(0)), std::true_type>) {
    return (node);
  } else {
    return *node;
  }
}
}  // namespace rosward_double
