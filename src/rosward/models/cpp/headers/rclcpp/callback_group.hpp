// SPDX-License-Identifier: Apache-2.0
// rclcpp: what do callbacks belong to, and what may run at any time? Groups, guard conditions, waitables, events, timers.
//
// Read from rclcpp, branches humble, jazzy and rolling (callback_group.hpp, guard_condition.hpp, waitable.hpp, event.hpp, timer.hpp).

namespace rclcpp
{
enum class CallbackGroupType { MutuallyExclusive, Reentrant };
namespace callback_group
{
using CallbackGroup = rclcpp::CallbackGroup;
using CallbackGroupType = rclcpp::CallbackGroupType;
}

class CallbackGroup
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  explicit CallbackGroup(CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true) {}
  const CallbackGroupType & type() const;
  bool automatically_add_to_executor_with_node() const;
  std::atomic_bool & can_be_taken_from();
};

class GuardCondition
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition)
  explicit GuardCondition(std::shared_ptr<Context> context = nullptr) {}
  void trigger() {}
  template<typename CallbackT>
  void set_on_trigger_callback(CallbackT callback) {rosward::schedule(callback, "guard condition", 1);}
};

class Waitable
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Waitable)
  virtual ~Waitable() {}
};

class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  bool set() {return true;}
  bool check();
  bool check_and_clear();
};

struct TimerInfo
{
  Time expected_call_time;
  Time actual_call_time;
};

class TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimerBase)
  TimerBase() {}
  virtual ~TimerBase() {}
  [[rosward::stops]] void cancel() {}
  bool is_canceled();
  [[rosward::stops]] void reset() {}
  bool is_ready();
  virtual bool is_steady();
  std::chrono::nanoseconds time_until_trigger();
  virtual void execute_callback() {}
  template<typename CallbackT>
  void set_on_reset_callback(CallbackT callback) {rosward::schedule(callback, "timer", 1);}
  void clear_on_reset_callback() {}
};

template<typename CallbackT>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)
  GenericTimer() {}
  template<typename ClockT, typename PeriodT>
  explicit GenericTimer(
    const ClockT & clock, const PeriodT & period, CallbackT && callback, std::shared_ptr<Context> context,
    bool autostart = true)
  {
    rosward::schedule(callback, "timer", *this);
  }
};

template<typename CallbackT>
class WallTimer : public GenericTimer<CallbackT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)
  WallTimer() {}
  template<typename PeriodT>
  WallTimer(const PeriodT & period, CallbackT && callback, std::shared_ptr<Context> context, bool autostart = true)
  {
    rosward::schedule(callback, "timer", *this);
  }
};
}  // namespace rclcpp
