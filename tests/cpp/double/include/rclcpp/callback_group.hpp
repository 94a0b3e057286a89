// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace rclcpp
{
enum class CallbackGroupType { MutuallyExclusive, Reentrant };

class CallbackGroup
{
public:
  using SharedPtr = std::shared_ptr<CallbackGroup>;
  using WeakPtr = std::weak_ptr<CallbackGroup>;
  explicit CallbackGroup(CallbackGroupType type) : type_(type) {}
  CallbackGroupType type() const { return type_; }

private:
  CallbackGroupType type_;
};
}  // namespace rclcpp
