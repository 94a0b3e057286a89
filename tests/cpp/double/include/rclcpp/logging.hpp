// SPDX-License-Identifier: Apache-2.0
// What is logged is computed, and said to nobody but an observer.
#pragma once

#include <sstream>
#include <string>
#include <type_traits>

#include "rosward_double/contents.hpp"

namespace rclcpp
{
class Logger
{
public:
  enum class Level { Unset = 0, Debug = 10, Info = 20, Warn = 30, Error = 40, Fatal = 50 };
  explicit Logger(const std::string & name = "") : name_(name) {}
  const char * get_name() const { return name_.c_str(); }
  Logger get_child(const std::string & suffix) { return Logger(name_ + "." + suffix); }
  void set_level(Level) {}

private:
  std::string name_;
};
inline Logger get_logger(const std::string & name) { return Logger(name); }
}  // namespace rclcpp

namespace rosward_double
{
template<typename T>
void tell_logged(std::ostream & text, const T & value)
{
  if constexpr (std::is_same_v<T, std::ostringstream>) {
    text << value.str();
  } else if constexpr (std::is_arithmetic_v<T>) {
    tell(text, value);
  } else if constexpr (std::is_convertible_v<const T &, std::string>) {
    tell(text, std::string(value));
  }
}
template<typename ... T>
void logged(const T & ... values)
{
  if (observed()) {
    std::ostringstream text;
    (tell_logged(text, values), ...);
    said("log", text.str());
  }
}
}  // namespace rosward_double

#define ROSWARD_DOUBLE_SAID(...) rosward_double::logged(__VA_ARGS__)
#define ROSWARD_DOUBLE_STREAM(logger, stream) \
  do { \
    std::ostringstream rosward_double_stream; \
    rosward_double_stream << stream; \
    rosward_double::logged(logger, rosward_double_stream); \
  } while (0)

#define RCLCPP_DEBUG(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_INFO(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_WARN(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_ERROR(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_FATAL(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_DEBUG_ONCE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_INFO_ONCE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_WARN_ONCE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_ERROR_ONCE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_FATAL_ONCE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_DEBUG_THROTTLE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_INFO_THROTTLE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_WARN_THROTTLE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_ERROR_THROTTLE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_FATAL_THROTTLE(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_INFO_EXPRESSION(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_WARN_EXPRESSION(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_ERROR_EXPRESSION(...) ROSWARD_DOUBLE_SAID(__VA_ARGS__)
#define RCLCPP_DEBUG_STREAM(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_INFO_STREAM(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_WARN_STREAM(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_ERROR_STREAM(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_FATAL_STREAM(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_INFO_STREAM_ONCE(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_WARN_STREAM_ONCE(logger, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, period, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, period, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, period, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, period, stream) ROSWARD_DOUBLE_STREAM(logger, stream)
