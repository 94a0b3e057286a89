// SPDX-License-Identifier: Apache-2.0
// Wait sets: nothing ever arrives.
#pragma once

#include <chrono>

namespace rclcpp
{
class WaitSet
{
public:
  template<class... T>
  explicit WaitSet(T &&...) {}
  template<class T>
  void add_subscription(T &&) {}
  template<class T>
  void remove_subscription(T &&) {}
  template<class Rep, class Period>
  int wait(std::chrono::duration<Rep, Period>) {return 0;}
};
}  // namespace rclcpp
