// SPDX-License-Identifier: Apache-2.0
// rclcpp: what is a QoS, and what do its presets and builders make of it?
//
// Read from rclcpp, branches humble, jazzy and rolling (qos.hpp, qos_overriding_options.hpp, event_handler.hpp).

namespace rclcpp
{
enum class HistoryPolicy { KeepLast = 1, KeepAll = 2, SystemDefault = 0, Unknown = 3 };
enum class ReliabilityPolicy { BestEffort = 2, Reliable = 1, SystemDefault = 0, BestAvailable = 4, Unknown = 3 };
enum class DurabilityPolicy { Volatile = 2, TransientLocal = 1, SystemDefault = 0, BestAvailable = 4, Unknown = 3 };
enum class LivelinessPolicy { Automatic = 1, ManualByTopic = 3, SystemDefault = 0, BestAvailable = 5, Unknown = 4 };
enum class QoSCompatibility { Ok = 0, Warning = 1, Error = 2 };

struct QoSInitialization
{
  rmw_qos_history_policy_t history_policy;
  size_t depth;

  QoSInitialization(
    rmw_qos_history_policy_t history_policy_arg, size_t depth_arg, bool print_depth_warning = true)
  : history_policy(history_policy_arg), depth(depth_arg) {}

  static QoSInitialization from_rmw(const rmw_qos_profile_t & rmw_qos)
  {
    return QoSInitialization(rmw_qos.history, rmw_qos.depth);
  }
};

struct KeepAll : public QoSInitialization
{
  KeepAll() : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};

struct KeepLast : public QoSInitialization
{
  explicit KeepLast(size_t depth, bool print_depth_warning = true)
  : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth) {}
};

class QoS
{
public:
  explicit QoS(
    const QoSInitialization & qos_initialization,
    const rmw_qos_profile_t & initial_profile = rmw_qos_profile_default)
  : rmw_qos_profile_{
      qos_initialization.history_policy, qos_initialization.depth, initial_profile.reliability, initial_profile.durability}
  {}

  QoS(size_t history_depth)
  : rmw_qos_profile_{
      RMW_QOS_POLICY_HISTORY_KEEP_LAST, history_depth, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE}
  {}

  rmw_qos_profile_t & get_rmw_qos_profile() {return rmw_qos_profile_;}

  QoS & history(HistoryPolicy history)
  {
    rmw_qos_profile_.history = history;
    return *this;
  }
  QoS & keep_last(size_t depth)
  {
    rmw_qos_profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
    rmw_qos_profile_.depth = depth;
    return *this;
  }
  QoS & keep_all()
  {
    rmw_qos_profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_ALL;
    rmw_qos_profile_.depth = 0;
    return *this;
  }
  QoS & reliability(ReliabilityPolicy reliability)
  {
    rmw_qos_profile_.reliability = reliability;
    return *this;
  }
  QoS & reliable() {return reliability(ReliabilityPolicy::Reliable);}
  QoS & best_effort() {return reliability(ReliabilityPolicy::BestEffort);}
  QoS & reliability_best_available() {return reliability(ReliabilityPolicy::BestAvailable);}
  QoS & durability(DurabilityPolicy durability)
  {
    rmw_qos_profile_.durability = durability;
    return *this;
  }
  QoS & durability_volatile() {return durability(DurabilityPolicy::Volatile);}
  QoS & transient_local() {return durability(DurabilityPolicy::TransientLocal);}
  QoS & durability_best_available() {return durability(DurabilityPolicy::BestAvailable);}
  QoS & deadline(const Duration & deadline) {return *this;}
  QoS & lifespan(const Duration & lifespan) {return *this;}
  QoS & liveliness(LivelinessPolicy liveliness)
  {
    rmw_qos_profile_.liveliness = liveliness;
    return *this;
  }
  QoS & liveliness_lease_duration(const Duration & liveliness_lease_duration) {return *this;}
  QoS & avoid_ros_namespace_conventions(bool avoid_ros_namespace_conventions)
  {
    rmw_qos_profile_.avoid_ros_namespace_conventions = avoid_ros_namespace_conventions;
    return *this;
  }

  HistoryPolicy history() const {return rmw_qos_profile_.history;}
  size_t depth() const {return rmw_qos_profile_.depth;}
  ReliabilityPolicy reliability() const {return rmw_qos_profile_.reliability;}
  DurabilityPolicy durability() const {return rmw_qos_profile_.durability;}
  LivelinessPolicy liveliness() const {return rmw_qos_profile_.liveliness;}
  Duration deadline() const;
  Duration lifespan() const;
  Duration liveliness_lease_duration() const;
  bool avoid_ros_namespace_conventions() const {return rmw_qos_profile_.avoid_ros_namespace_conventions;}

private:
  rmw_qos_profile_t rmw_qos_profile_;
};

class ClockQoS : public QoS
{
public:
  explicit ClockQoS(const QoSInitialization & qos_initialization = KeepLast(1)) : QoS(qos_initialization)
  {
    best_effort();
  }
};

class SensorDataQoS : public QoS
{
public:
  explicit SensorDataQoS(const QoSInitialization & qos_initialization = KeepLast(5))
  : QoS(qos_initialization, rmw_qos_profile_sensor_data) {}
};

class ParametersQoS : public QoS
{
public:
  explicit ParametersQoS(const QoSInitialization & qos_initialization = KeepLast(1000))
  : QoS(qos_initialization, rmw_qos_profile_parameters) {}
};

class ServicesQoS : public QoS
{
public:
  explicit ServicesQoS(const QoSInitialization & qos_initialization = KeepLast(10))
  : QoS(qos_initialization, rmw_qos_profile_services_default) {}
};

class ParameterEventsQoS : public QoS
{
public:
  explicit ParameterEventsQoS(const QoSInitialization & qos_initialization = KeepLast(1000))
  : QoS(qos_initialization, rmw_qos_profile_parameter_events) {}
};

class RosoutQoS : public QoS
{
public:
  explicit RosoutQoS(const QoSInitialization & rosout_qos_initialization = KeepLast(1000))
  : QoS(rosout_qos_initialization, rcl_qos_profile_rosout_default) {}
};

class SystemDefaultsQoS : public QoS
{
public:
  explicit SystemDefaultsQoS(
    const QoSInitialization & qos_initialization = QoSInitialization(RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0))
  : QoS(qos_initialization, rmw_qos_profile_system_default) {}
};

class BestAvailableQoS : public QoS
{
public:
  explicit BestAvailableQoS(const QoSInitialization & qos_initialization = KeepLast(10))
  : QoS(qos_initialization, rmw_qos_profile_best_available) {}
};

enum class QosPolicyKind {
  AvoidRosNamespaceConventions = 512, Deadline = 4, Depth = 128, Durability = 2, History = 32, Lifespan = 64,
  Liveliness = 8, LivelinessLeaseDuration = 256, Reliability = 16, Invalid = 1
};

using QosCallbackResult = rcl_interfaces::msg::SetParametersResult;
using QosCallback = std::function<QosCallbackResult(const QoS &)>;

class QosOverridingOptions
{
public:
  QosOverridingOptions() = default;
  QosOverridingOptions(
    std::initializer_list<QosPolicyKind> policy_kinds, QosCallback validation_callback = nullptr, std::string id = std::string())
  : id_(id), policy_kinds_(policy_kinds), validation_callback_(validation_callback) {}

  const std::string & get_id() const {return id_;}
  const std::vector<QosPolicyKind> & get_policy_kinds() const {return policy_kinds_;}
  const QosCallback & get_validation_callback() const {return validation_callback_;}

  static QosOverridingOptions with_default_policies(QosCallback validation_callback = nullptr, std::string id = std::string())
  {
    return QosOverridingOptions(
      {QosPolicyKind::History, QosPolicyKind::Depth, QosPolicyKind::Reliability}, validation_callback, id);
  }

private:
  std::string id_;
  std::vector<QosPolicyKind> policy_kinds_;
  QosCallback validation_callback_;
};

namespace detail
{
// A QoS of a depth, a profile or a QoS.
QoS as_qos(const rmw_qos_profile_t & profile) {return QoS(QoSInitialization::from_rmw(profile), profile);}
QoS as_qos(const QoS & qos) {return qos;}
QoS as_qos(const QoSInitialization & initialization) {return QoS(initialization);}
QoS as_qos(size_t depth) {return QoS(depth);}

// The words that a parameter has for policies.
std::string history_word(int policy)
{
  return policy == 1 ? "keep_last" : policy == 2 ? "keep_all" : policy == 0 ? "system_default" : "unknown";
}
std::string reliability_word(int policy)
{
  return policy == 1 ? "reliable" : policy == 2 ? "best_effort" : policy == 0 ? "system_default" :
         policy == 4 ? "best_available" : "unknown";
}
std::string durability_word(int policy)
{
  return policy == 1 ? "transient_local" : policy == 2 ? "volatile" : policy == 0 ? "system_default" :
         policy == 4 ? "best_available" : "unknown";
}
std::string liveliness_word(int policy)
{
  return policy == 1 ? "automatic" : policy == 3 ? "manual_by_topic" : policy == 0 ? "system_default" : "unknown";
}

template<typename NodeT, typename ValueT>
void declare_once(NodeT * node, const std::string & name, const ValueT & value)
{
  if (!node->has_parameter(name)) {
    node->declare_parameter(name, value);
  }
}

template<typename NodeT>
void declare_qos_parameters(
  NodeT * node, const std::string & kind, const std::string & topic, const QoS & qos, const QosOverridingOptions & options)
{
  if (options.get_policy_kinds().empty()) {
    return;
  }
  const std::string id = options.get_id().empty() ? "" : "_" + options.get_id();
  const std::string before = "qos_overrides." + rosward::resolve_name(node, topic, "topic") + "." + kind + id + ".";
  for (auto policy : options.get_policy_kinds()) {
    if (policy == QosPolicyKind::Depth) {
      declare_once(node, before + "depth", qos.depth());
    } else if (policy == QosPolicyKind::AvoidRosNamespaceConventions) {
      declare_once(node, before + "avoid_ros_namespace_conventions", qos.avoid_ros_namespace_conventions());
    } else if (policy == QosPolicyKind::Deadline) {
      declare_once(node, before + "deadline", 0);
    } else if (policy == QosPolicyKind::Lifespan) {
      declare_once(node, before + "lifespan", 0);
    } else if (policy == QosPolicyKind::LivelinessLeaseDuration) {
      declare_once(node, before + "liveliness_lease_duration", 0);
    } else if (policy == QosPolicyKind::Durability) {
      declare_once(node, before + "durability", durability_word(qos.durability()));
    } else if (policy == QosPolicyKind::History) {
      declare_once(node, before + "history", history_word(qos.history()));
    } else if (policy == QosPolicyKind::Liveliness) {
      declare_once(node, before + "liveliness", liveliness_word(qos.liveliness()));
    } else if (policy == QosPolicyKind::Reliability) {
      declare_once(node, before + "reliability", reliability_word(qos.reliability()));
    }
  }
  if (options.get_validation_callback()) {
    rosward::schedule(options.get_validation_callback(), "parameters", qos);
  }
}
}  // namespace detail
}  // namespace rclcpp
