// SPDX-License-Identifier: Apache-2.0
// Qualities of service: they are accepted, nothing depends on them.
#pragma once

#include <chrono>
#include <cstddef>

#include "rclcpp/time.hpp"

enum rmw_qos_reliability_policy_t { RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT };
enum rmw_qos_history_policy_t { RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, RMW_QOS_POLICY_HISTORY_KEEP_LAST, RMW_QOS_POLICY_HISTORY_KEEP_ALL };
enum rmw_qos_durability_policy_t { RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL, RMW_QOS_POLICY_DURABILITY_VOLATILE };
enum rmw_qos_liveliness_policy_t { RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, RMW_QOS_POLICY_LIVELINESS_AUTOMATIC };

struct rmw_qos_profile_t
{
  rmw_qos_history_policy_t history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  size_t depth = 10;
  rmw_qos_reliability_policy_t reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  rmw_qos_durability_policy_t durability = RMW_QOS_POLICY_DURABILITY_VOLATILE;
};
inline const rmw_qos_profile_t rmw_qos_profile_default, rmw_qos_profile_sensor_data, rmw_qos_profile_services_default,
  rmw_qos_profile_parameters, rmw_qos_profile_system_default;

namespace rclcpp
{
enum class HistoryPolicy { KeepLast, KeepAll, SystemDefault, Unknown };
enum class ReliabilityPolicy { BestEffort, Reliable, SystemDefault, BestAvailable, Unknown };
enum class DurabilityPolicy { Volatile, TransientLocal, SystemDefault, BestAvailable, Unknown };
enum class LivelinessPolicy { Automatic, ManualByTopic, SystemDefault, BestAvailable, Unknown };

struct QoSInitialization
{
  size_t depth = 10;
  static QoSInitialization from_rmw(const rmw_qos_profile_t & profile) { return {profile.depth}; }
};
struct KeepLast : QoSInitialization
{
  explicit KeepLast(size_t depth) : QoSInitialization{depth} {}
};
struct KeepAll : QoSInitialization
{
};

class QoS
{
public:
  QoS(const QoSInitialization & how, const rmw_qos_profile_t & = {}) : depth_(how.depth) {}  // NOLINT
  QoS(size_t depth) : depth_(depth) {}  // NOLINT
  size_t depth() const { return depth_; }
  QoS & keep_last(size_t depth)
  {
    depth_ = depth;
    return *this;
  }
  QoS & keep_all() { return *this; }
  QoS & reliable() { return *this; }
  QoS & best_effort() { return *this; }
  QoS & reliability_best_available() { return *this; }
  QoS & durability_volatile() { return *this; }
  QoS & transient_local() { return *this; }
  template<typename P>
  QoS & history(P)
  {
    return *this;
  }
  template<typename P>
  QoS & reliability(P)
  {
    return *this;
  }
  template<typename P>
  QoS & durability(P)
  {
    return *this;
  }
  template<typename P>
  QoS & liveliness(P)
  {
    return *this;
  }
  QoS & deadline(const Duration &) { return *this; }
  QoS & lifespan(const Duration &) { return *this; }
  QoS & liveliness_lease_duration(const Duration &) { return *this; }
  QoS & avoid_ros_namespace_conventions(bool) { return *this; }
  rmw_qos_profile_t get_rmw_qos_profile() const { return {}; }

private:
  size_t depth_;
};

#define ROSWARD_DOUBLE_QOS(NAME, DEPTH) \
  class NAME : public QoS \
  { \
  public: \
    explicit NAME(const QoSInitialization & how = KeepLast(DEPTH)) : QoS(how) {} \
  };
ROSWARD_DOUBLE_QOS(SensorDataQoS, 5)
ROSWARD_DOUBLE_QOS(SystemDefaultsQoS, 0)
ROSWARD_DOUBLE_QOS(ServicesQoS, 10)
ROSWARD_DOUBLE_QOS(ParametersQoS, 1000)
ROSWARD_DOUBLE_QOS(ParameterEventsQoS, 1000)
ROSWARD_DOUBLE_QOS(RosoutQoS, 1000)
ROSWARD_DOUBLE_QOS(ClockQoS, 1)
ROSWARD_DOUBLE_QOS(BestAvailableQoS, 10)
#undef ROSWARD_DOUBLE_QOS

struct QosOverridingOptions
{
  static QosOverridingOptions with_default_policies() { return {}; }
};
}  // namespace rclcpp
