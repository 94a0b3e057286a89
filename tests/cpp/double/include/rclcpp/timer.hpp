// SPDX-License-Identifier: Apache-2.0
// What ticks: twice, as soon as the node is spun.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>

#include "rosward_double/core.hpp"

namespace rclcpp
{
class Event
{
public:
  using SharedPtr = std::shared_ptr<Event>;
  bool set() { return set_ = true; }
  bool check() { return set_; }

private:
  bool set_ = false;
};

class TimerBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<TimerBase>;
  using WeakPtr = std::weak_ptr<TimerBase>;
  template<typename F>
  TimerBase(F callback, bool starts) : canceled_(!starts)
  {
    if constexpr (std::is_invocable_v<F &>) {
      callback_ = std::move(callback);
    } else {
      callback_ = [this, callback = std::move(callback)]() mutable { callback(*this); };
    }
  }
  void cancel() { canceled_ = true; }
  void reset() { canceled_ = false; }
  bool is_canceled() const { return canceled_; }
  bool is_ready() const { return !canceled_; }
  bool is_steady() const { return true; }
  void execute_callback() { callback_(); }
  std::chrono::nanoseconds time_until_trigger() const { return std::chrono::nanoseconds(0); }
  bool serve() override
  {
    if (canceled_ || !turn()) {
      return false;
    }
    callback_();
    return true;
  }

private:
  bool canceled_;
  std::function<void()> callback_;
};
template<typename F>
using WallTimer = TimerBase;
template<typename F>
using GenericTimer = TimerBase;
}  // namespace rclcpp
