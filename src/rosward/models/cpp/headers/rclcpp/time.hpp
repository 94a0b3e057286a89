// SPDX-License-Identifier: Apache-2.0
// rclcpp: times, durations, clocks, rates. When something happens decides nothing here: numbers are kept where they are written.
//
// Read from rclcpp, branches humble, jazzy and rolling (duration.hpp, time.hpp, clock.hpp, rate.hpp, time_source.hpp).

namespace rclcpp
{
class [[rosward::holds]] Duration
{
public:
  template<typename T>
  Duration(const T & duration) {}
  Duration(int32_t seconds, uint32_t nanoseconds) {}
  static Duration max() {return Duration(0, 0);}
  static Duration from_seconds(double seconds) {return Duration(0, 0);}
  static Duration from_nanoseconds(int64_t nanoseconds) {return Duration(0, 0);}
  static Duration from_rmw_time(rmw_time_t duration) {return Duration(0, 0);}
  operator builtin_interfaces::msg::Duration() const {return builtin_interfaces::msg::Duration();}
  bool operator==(const Duration & rhs) const;
  bool operator!=(const Duration & rhs) const;
  bool operator<(const Duration & rhs) const;
  bool operator<=(const Duration & rhs) const;
  bool operator>=(const Duration & rhs) const;
  bool operator>(const Duration & rhs) const;
  Duration operator+(const Duration & rhs) const {return Duration(0, 0);}
  Duration operator-(const Duration & rhs) const {return Duration(0, 0);}
  Duration operator*(double scale) const {return Duration(0, 0);}
  Duration & operator+=(const Duration & rhs) {return *this;}
  Duration & operator-=(const Duration & rhs) {return *this;}
  Duration & operator*=(double scale) {return *this;}
  int64_t nanoseconds() const;
  double seconds() const;
  template<class DurationT>
  DurationT to_chrono() const {return rosward::unknown("call", "duration");}
  rmw_time_t to_rmw_time() const {return rmw_time_t();}
};

class [[rosward::holds]] Time
{
public:
  Time() {}
  template<typename T>
  explicit Time(const T & time, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) {}
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) {}
  static Time max(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) {return Time();}
  operator builtin_interfaces::msg::Time() const {return rosward::message<builtin_interfaces::msg::Time>();}
  bool operator==(const Time & rhs) const;
  bool operator!=(const Time & rhs) const;
  bool operator<(const Time & rhs) const;
  bool operator<=(const Time & rhs) const;
  bool operator>=(const Time & rhs) const;
  bool operator>(const Time & rhs) const;
  Time operator+(const Duration & rhs) const {return Time();}
  template<typename T>
  auto operator-(const T & rhs) const {return Duration(0, 0);}
  Time & operator+=(const Duration & rhs) {return *this;}
  Time & operator-=(const Duration & rhs) {return *this;}
  int64_t nanoseconds() const {return rosward::unknown("random", "time", "int");}
  double seconds() const {return rosward::unknown("random", "time", "float");}
  rcl_clock_type_t get_clock_type() const;
};

class JumpHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)
};

class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)
  explicit Clock(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) {}
  [[rosward::source("clock")]] Time now() const {return Time();}
  bool sleep_until(Time until, std::shared_ptr<Context> context = nullptr) {std::this_thread::yield(); return true;}
  bool sleep_for(Duration rel_time, std::shared_ptr<Context> context = nullptr) {std::this_thread::yield(); return true;}
  bool started();
  bool wait_until_started(std::shared_ptr<Context> context = nullptr) {return true;}
  bool ros_time_is_active();
  rcl_clock_type_t get_clock_type() const;
  template<typename BeforeT, typename AfterT>
  JumpHandler::SharedPtr create_jump_callback(BeforeT pre_callback, AfterT post_callback, const rcl_jump_threshold_t & threshold)
  {
    rosward::schedule(pre_callback, "time jump");
    rosward::schedule(post_callback, "time jump", rosward::unknown("live", "jump of the time"));
    return std::make_shared<JumpHandler>();
  }
};

class RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(RateBase)
  virtual ~RateBase() {}
};

class Rate : public RateBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)
  template<typename T>
  explicit Rate(const T & rate, Clock::SharedPtr clock = nullptr) {}
  virtual bool sleep() {std::this_thread::yield(); return true;}
  virtual void reset() {}
  virtual rcl_clock_type_t get_type() const;
  std::chrono::nanoseconds period() const;
};

class WallRate : public Rate
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallRate)
  template<typename T>
  explicit WallRate(const T & rate) : Rate(rate) {}
};

template<class Clock>
using GenericRate = Rate;

class TimeSource
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)
  template<typename NodeT>
  explicit TimeSource(NodeT node) {attachNode(node);}
  TimeSource() {}
  template<typename NodeT>
  void attachNode(NodeT node)
  {
    rosward::create("subscription", node, "/parameter_events", rosward::type<rcl_interfaces::msg::ParameterEvent>(), 1000);
  }
  void detachNode() {}
  void attachClock(Clock::SharedPtr clock) {}
  void detachClock(Clock::SharedPtr clock) {}
};
}  // namespace rclcpp
