// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "message_filters/subscriber.h"

namespace message_filters
{
template<typename ... M>
class Synchronized
{
public:
  template<typename ... F>
  void connectInput(Filter & first, F & ...)
  {
    first.then([this] {
        const auto all = callbacks_;
        for (const auto & each : all) {
          each();
        }
      });
  }
  template<typename F>
  Connection registerCallback(F callback)
  {
    callbacks_.push_back(with_defaults<M...>(std::move(callback)));
    return {};
  }
  template<typename T, typename ... P>
  Connection registerCallback(void (T::* method)(P...), T * object)
  {
    return registerCallback([method, object](const std::shared_ptr<const M> & ... message) { (object->*method)(message...); });
  }

private:
  std::vector<std::function<void()>> callbacks_;
};

namespace sync_policies
{
#define ROSWARD_DOUBLE_POLICY(NAME) \
  template<typename ... M> \
  struct NAME \
  { \
    using Joined = Synchronized<M...>; \
    explicit NAME(uint32_t) {} \
  };
ROSWARD_DOUBLE_POLICY(ExactTime)
ROSWARD_DOUBLE_POLICY(ApproximateTime)
ROSWARD_DOUBLE_POLICY(ApproximateEpsilonTime)
#undef ROSWARD_DOUBLE_POLICY
}  // namespace sync_policies

template<typename Policy>
class Synchronizer : public Policy::Joined
{
public:
  using SharedPtr = std::shared_ptr<Synchronizer>;
  explicit Synchronizer(const Policy &) {}
  template<typename ... F>
  explicit Synchronizer(const Policy &, F & ... filters)
  {
    this->connectInput(filters...);
  }
  void setMaxIntervalDuration(const rclcpp::Duration &) {}
};

template<typename ... M>
class TimeSynchronizer : public Synchronized<M...>
{
public:
  explicit TimeSynchronizer(uint32_t) {}
  TimeSynchronizer(Filter & first, Filter & second, uint32_t)
  {
    this->connectInput(first, second);
  }
  TimeSynchronizer(Filter & first, Filter & second, Filter & third, uint32_t)
  {
    this->connectInput(first, second, third);
  }
};

template<typename M>
class Cache : public SimpleFilter<M>
{
public:
  explicit Cache(Filter & filter, unsigned int = 1)
  {
    filter.then([this] { this->pass(); });
  }
};
}  // namespace message_filters
