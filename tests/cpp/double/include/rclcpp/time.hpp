// SPDX-License-Identifier: Apache-2.0
// Time stands still at zero; sleeping takes none.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"

enum rcl_clock_type_t { RCL_CLOCK_UNINITIALIZED = 0, RCL_ROS_TIME, RCL_SYSTEM_TIME, RCL_STEADY_TIME };
using rcl_time_point_value_t = int64_t;
using rcl_duration_value_t = int64_t;
#define RCL_S_TO_NS(seconds) ((seconds) * (1000LL * 1000LL * 1000LL))
#define RCL_MS_TO_NS(milliseconds) ((milliseconds) * (1000LL * 1000LL))
#define RCL_NS_TO_S(nanoseconds) ((nanoseconds) / (1000LL * 1000LL * 1000LL))

namespace rclcpp
{
class Duration
{
public:
  Duration() = default;
  Duration(int32_t seconds, uint32_t nanoseconds) : value_(seconds * 1000000000LL + nanoseconds) {}
  template<typename R, typename P>
  Duration(const std::chrono::duration<R, P> & value)  // NOLINT: implicit, as in rclcpp
  : value_(std::chrono::duration_cast<std::chrono::nanoseconds>(value).count())
  {
  }
  Duration(const builtin_interfaces::msg::Duration & m) : Duration(m.sec, m.nanosec) {}  // NOLINT
  static Duration from_seconds(double seconds) { return from_nanoseconds(static_cast<int64_t>(seconds * 1e9)); }
  static Duration from_nanoseconds(int64_t value)
  {
    Duration made;
    made.value_ = value;
    return made;
  }
  static Duration max() { return from_nanoseconds(INT64_MAX); }
  int64_t nanoseconds() const { return value_; }
  double seconds() const { return static_cast<double>(value_) * 1e-9; }
  template<typename D>
  D to_chrono() const
  {
    return std::chrono::duration_cast<D>(std::chrono::nanoseconds(value_));
  }
  operator builtin_interfaces::msg::Duration() const { return {}; }
  bool operator<(const Duration & o) const { return value_ < o.value_; }
  bool operator>(const Duration & o) const { return value_ > o.value_; }
  bool operator<=(const Duration & o) const { return value_ <= o.value_; }
  bool operator>=(const Duration & o) const { return value_ >= o.value_; }
  bool operator==(const Duration & o) const { return value_ == o.value_; }
  bool operator!=(const Duration & o) const { return value_ != o.value_; }
  Duration operator+(const Duration & o) const { return from_nanoseconds(value_ + o.value_); }
  Duration operator-(const Duration & o) const { return from_nanoseconds(value_ - o.value_); }
  Duration operator*(double factor) const { return from_seconds(seconds() * factor); }

private:
  int64_t value_ = 0;
};

class Time
{
public:
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t = RCL_SYSTEM_TIME) : value_(nanoseconds) {}
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t = RCL_SYSTEM_TIME) : value_(seconds * 1000000000LL + nanoseconds) {}
  Time(const builtin_interfaces::msg::Time & m, rcl_clock_type_t = RCL_ROS_TIME) : Time(m.sec, m.nanosec) {}  // NOLINT
  operator builtin_interfaces::msg::Time() const
  {
    builtin_interfaces::msg::Time m;
    m.sec = static_cast<int32_t>(value_ / 1000000000LL);
    m.nanosec = static_cast<uint32_t>(value_ % 1000000000LL);
    return m;
  }
  int64_t nanoseconds() const { return value_; }
  double seconds() const { return static_cast<double>(value_) * 1e-9; }
  rcl_clock_type_t get_clock_type() const { return RCL_ROS_TIME; }
  bool operator<(const Time & o) const { return value_ < o.value_; }
  bool operator>(const Time & o) const { return value_ > o.value_; }
  bool operator<=(const Time & o) const { return value_ <= o.value_; }
  bool operator>=(const Time & o) const { return value_ >= o.value_; }
  bool operator==(const Time & o) const { return value_ == o.value_; }
  bool operator!=(const Time & o) const { return value_ != o.value_; }
  Time operator+(const Duration & o) const { return Time(value_ + o.nanoseconds()); }
  Time operator-(const Duration & o) const { return Time(value_ - o.nanoseconds()); }
  Duration operator-(const Time & o) const { return Duration::from_nanoseconds(value_ - o.value_); }

private:
  int64_t value_;
};

class Clock
{
public:
  using SharedPtr = std::shared_ptr<Clock>;
  using ConstSharedPtr = std::shared_ptr<const Clock>;
  explicit Clock(rcl_clock_type_t type = RCL_SYSTEM_TIME) : type_(type) {}
  Time now() const { return Time(int64_t{0}, type_); }
  bool sleep_for(const Duration &) { return true; }
  bool sleep_until(const Time &) { return true; }
  bool ros_time_is_active() { return false; }
  bool started() { return true; }
  bool wait_until_started() { return true; }
  rcl_clock_type_t get_clock_type() const { return type_; }

private:
  rcl_clock_type_t type_;
};

class RateBase
{
public:
  using SharedPtr = std::shared_ptr<RateBase>;
  virtual ~RateBase() = default;
  virtual bool sleep() { return true; }
  virtual void reset() {}
};
class Rate : public RateBase
{
public:
  using SharedPtr = std::shared_ptr<Rate>;
  explicit Rate(double) {}
  explicit Rate(const Duration &) {}
  Rate(double, Clock::SharedPtr) {}
  template<typename R, typename P>
  explicit Rate(const std::chrono::duration<R, P> &)
  {
  }
};
using WallRate = Rate;
}  // namespace rclcpp
