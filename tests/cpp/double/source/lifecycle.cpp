// SPDX-License-Identifier: Apache-2.0
// The states of a lifecycle node.
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace rclcpp_lifecycle
{
namespace
{
enum : uint8_t { UNCONFIGURED = 1, INACTIVE = 2, ACTIVE = 3, FINALIZED = 4 };
const char * const LABELS[] = {"unknown", "unconfigured", "inactive", "active", "finalized"};
}  // namespace

LifecycleNode::LifecycleNode(const std::string & name, const std::string & space, const rclcpp::NodeOptions & options, bool services)
: NodeMethods(name, space, options)
{
  const std::string own = core()->full_name();
  core()->system("pub", own + "/transition_event", "lifecycle_msgs/msg/TransitionEvent");
  if (services) {
    core()->system("ss", own + "/change_state", "lifecycle_msgs/srv/ChangeState");
    core()->system("ss", own + "/get_state", "lifecycle_msgs/srv/GetState");
    core()->system("ss", own + "/get_available_states", "lifecycle_msgs/srv/GetAvailableStates");
    core()->system("ss", own + "/get_available_transitions", "lifecycle_msgs/srv/GetAvailableTransitions");
    core()->system("ss", own + "/get_transition_graph", "lifecycle_msgs/srv/GetAvailableTransitions");
  }
  core()->transitions = [this](bool finish) { step(finish); };
}
LifecycleNode::~LifecycleNode() { core()->transitions = nullptr; }

// One transition: what it calls decides where it leads. An exception is an error.
template<typename F>
const State & LifecycleNode::go(uint8_t from, uint8_t to, F callback)
{
  if (from != state_.id()) {
    return state_;
  }
  CallbackReturn result = CallbackReturn::ERROR;
  try {
    result = callback();
  } catch (const std::exception &) {
  }
  if (result == CallbackReturn::ERROR) {
    to = call("error", [this](const State & s) { return on_error(s); }) == CallbackReturn::SUCCESS ? UNCONFIGURED : FINALIZED;
  } else if (result == CallbackReturn::FAILURE) {
    to = from;
  }
  state_ = State(to, LABELS[to]);
  return state_;
}

const State & LifecycleNode::configure()
{
  return go(UNCONFIGURED, INACTIVE, [this] { return call("configure", [this](const State & s) { return on_configure(s); }); });
}
const State & LifecycleNode::activate()
{
  return go(INACTIVE, ACTIVE, [this] { return call("activate", [this](const State & s) { return on_activate(s); }); });
}
const State & LifecycleNode::deactivate()
{
  return go(ACTIVE, INACTIVE, [this] { return call("deactivate", [this](const State & s) { return on_deactivate(s); }); });
}
const State & LifecycleNode::cleanup()
{
  return go(INACTIVE, UNCONFIGURED, [this] { return call("cleanup", [this](const State & s) { return on_cleanup(s); }); });
}
const State & LifecycleNode::shutdown()
{
  const uint8_t from = state_.id();
  return from == FINALIZED ? state_ : go(from, FINALIZED, [this] { return call("shutdown", [this](const State & s) { return on_shutdown(s); }); });
}
const State & LifecycleNode::trigger_transition(uint8_t id)
{
  switch (id) {
    case 1: return configure();
    case 2: return cleanup();
    case 3: return activate();
    case 4: return deactivate();
    default: return shutdown();
  }
}

LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State &)
{
  for (const auto & each : managed_) {
    if (const auto entity = each.lock()) {
      entity->on_activate();
    }
  }
  return CallbackReturn::SUCCESS;
}
LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  for (const auto & each : managed_) {
    if (const auto entity = each.lock()) {
      entity->on_deactivate();
    }
  }
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::step(bool finish)
{
  if (!finish) {
    configure();
    activate();
  } else {
    deactivate();
    cleanup();
    shutdown();
  }
}
}  // namespace rclcpp_lifecycle
