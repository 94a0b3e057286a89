// SPDX-License-Identifier: Apache-2.0
// Lifecycle nodes: spinning leads them from one state to the next.
#pragma once

#include <memory>
#include <string>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp_lifecycle
{
class State
{
public:
  explicit State(uint8_t id = 1, const std::string & label = "unconfigured") : id_(id), label_(label) {}
  virtual ~State() = default;
  uint8_t id() const { return id_; }
  std::string label() const { return label_; }

private:
  uint8_t id_;
  std::string label_;
};

namespace node_interfaces
{
class LifecycleNodeInterface
{
public:
  enum class CallbackReturn : uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State &) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_cleanup(const State &) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_shutdown(const State &) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_activate(const State &) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_deactivate(const State &) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_error(const State &) { return CallbackReturn::FAILURE; }
};
}  // namespace node_interfaces

class ManagedEntityInterface
{
public:
  virtual ~ManagedEntityInterface() = default;
  virtual void on_activate() {}
  virtual void on_deactivate() {}
};

template<typename M, typename A = std::allocator<void>>
class LifecyclePublisher : public rclcpp::Publisher<M>, public ManagedEntityInterface
{
public:
  using SharedPtr = std::shared_ptr<LifecyclePublisher>;
  using ConstSharedPtr = std::shared_ptr<const LifecyclePublisher>;
  using UniquePtr = std::unique_ptr<LifecyclePublisher>;
  using rclcpp::Publisher<M>::Publisher;
  void on_activate() override { active_ = true; }
  void on_deactivate() override { active_ = false; }
  bool is_activated() const { return active_; }

private:
  bool active_ = false;
};

class LifecycleNode
  : public rclcpp::NodeMethods, public node_interfaces::LifecycleNodeInterface, public std::enable_shared_from_this<LifecycleNode>
{
public:
  using SharedPtr = std::shared_ptr<LifecycleNode>;
  using ConstSharedPtr = std::shared_ptr<const LifecycleNode>;
  using WeakPtr = std::weak_ptr<LifecycleNode>;
  using UniquePtr = std::unique_ptr<LifecycleNode>;
  explicit LifecycleNode(const std::string & name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool services = true)
  : LifecycleNode(name, "", options, services)
  {
  }
  LifecycleNode(
    const std::string & name, const std::string & space, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool services = true);
  ~LifecycleNode() override;
  template<typename ... Args>
  static SharedPtr make_shared(Args && ... args)
  {
    return std::make_shared<LifecycleNode>(std::forward<Args>(args)...);
  }

  template<typename M, typename A = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<M>> create_publisher(
    const std::string & topic, const rclcpp::QoS &, const rclcpp::PublisherOptionsWithAllocator<A> & = {})
  {
    auto made = rosward_double::publisher<M, LifecyclePublisher<M>>(*core(), topic);
    managed_.push_back(made);
    return made;
  }

  using Registered = std::function<node_interfaces::LifecycleNodeInterface::CallbackReturn(const State &)>;
#define ROSWARD_DOUBLE_TRANSITION(NAME) \
  bool register_on_ ## NAME(Registered callback) \
  { \
    registered_[#NAME] = std::move(callback); \
    return true; \
  }
  ROSWARD_DOUBLE_TRANSITION(configure)
  ROSWARD_DOUBLE_TRANSITION(cleanup)
  ROSWARD_DOUBLE_TRANSITION(shutdown)
  ROSWARD_DOUBLE_TRANSITION(activate)
  ROSWARD_DOUBLE_TRANSITION(deactivate)
  ROSWARD_DOUBLE_TRANSITION(error)
#undef ROSWARD_DOUBLE_TRANSITION

  const State & get_current_state() const { return state_; }
  const State & configure();
  const State & activate();
  const State & deactivate();
  const State & cleanup();
  const State & shutdown();
  const State & trigger_transition(uint8_t id);

  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;
  CallbackReturn on_activate(const State &) override;
  CallbackReturn on_deactivate(const State &) override;

private:
  template<typename F>
  const State & go(uint8_t from, uint8_t to, F callback);
  void step(bool finish);
  // Calls what was registered for a transition, else the method.
  template<typename F>
  CallbackReturn call(const std::string & name, F method)
  {
    const auto found = registered_.find(name);
    return found == registered_.end() ? method(state_) : found->second(state_);
  }
  std::map<std::string, Registered> registered_;
  State state_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> managed_;
};
}  // namespace rclcpp_lifecycle
