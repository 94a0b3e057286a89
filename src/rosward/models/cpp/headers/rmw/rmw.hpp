// SPDX-License-Identifier: Apache-2.0
// rmw: which QoS profiles are there in C?
//
// Written from the documentation of rmw (types.h, qos_profiles.h), humble to rolling.

enum rmw_qos_reliability_policy_t {
  RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT = 0,
  RMW_QOS_POLICY_RELIABILITY_RELIABLE = 1,
  RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT = 2,
  RMW_QOS_POLICY_RELIABILITY_UNKNOWN = 3,
  RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE = 4
};
enum rmw_qos_history_policy_t {
  RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT = 0,
  RMW_QOS_POLICY_HISTORY_KEEP_LAST = 1,
  RMW_QOS_POLICY_HISTORY_KEEP_ALL = 2,
  RMW_QOS_POLICY_HISTORY_UNKNOWN = 3
};
enum rmw_qos_durability_policy_t {
  RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT = 0,
  RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL = 1,
  RMW_QOS_POLICY_DURABILITY_VOLATILE = 2,
  RMW_QOS_POLICY_DURABILITY_UNKNOWN = 3,
  RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE = 4
};
enum rmw_qos_liveliness_policy_t {
  RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT = 0,
  RMW_QOS_POLICY_LIVELINESS_AUTOMATIC = 1,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_NODE = 2,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3,
  RMW_QOS_POLICY_LIVELINESS_UNKNOWN = 4,
  RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE = 5
};
enum rmw_qos_policy_kind_t {
  RMW_QOS_POLICY_INVALID = 1,
  RMW_QOS_POLICY_DURABILITY = 2,
  RMW_QOS_POLICY_DEADLINE = 4,
  RMW_QOS_POLICY_LIVELINESS = 8,
  RMW_QOS_POLICY_RELIABILITY = 16,
  RMW_QOS_POLICY_HISTORY = 32,
  RMW_QOS_POLICY_LIFESPAN = 64,
  RMW_QOS_POLICY_DEPTH = 128,
  RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION = 256,
  RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS = 512
};
enum rmw_unique_network_flow_endpoints_requirement_t {
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_NOT_REQUIRED = 0,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED = 1,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_OPTIONALLY_REQUIRED = 2,
  RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_SYSTEM_DEFAULT = 3
};

struct rmw_time_t {
  uint64_t sec = 0;
  uint64_t nsec = 0;
};

struct rmw_qos_profile_t {
  rmw_qos_history_policy_t history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  size_t depth = 10;
  rmw_qos_reliability_policy_t reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  rmw_qos_durability_policy_t durability = RMW_QOS_POLICY_DURABILITY_VOLATILE;
  rmw_time_t deadline;
  rmw_time_t lifespan;
  rmw_qos_liveliness_policy_t liveliness = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT;
  rmw_time_t liveliness_lease_duration;
  bool avoid_ros_namespace_conventions = false;
};

typedef rmw_qos_profile_t rmw_qos_profile_s;

const rmw_qos_profile_t rmw_qos_profile_default = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 10, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
const rmw_qos_profile_t rmw_qos_profile_sensor_data = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 5, RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_DURABILITY_VOLATILE};
const rmw_qos_profile_t rmw_qos_profile_services_default = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 10, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
const rmw_qos_profile_t rmw_qos_profile_parameters = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
const rmw_qos_profile_t rmw_qos_profile_parameter_events = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
const rmw_qos_profile_t rmw_qos_profile_system_default = {
  RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0, RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT};
const rmw_qos_profile_t rmw_qos_profile_best_available = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 10, RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE,
  RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE};
const rmw_qos_profile_t rmw_qos_profile_unknown = {
  RMW_QOS_POLICY_HISTORY_UNKNOWN, 0, RMW_QOS_POLICY_RELIABILITY_UNKNOWN, RMW_QOS_POLICY_DURABILITY_UNKNOWN};

struct rmw_request_id_t {
  int8_t writer_guid[16];
  int64_t sequence_number;
};
struct rmw_service_info_t {
  int64_t source_timestamp;
  int64_t received_timestamp;
  rmw_request_id_t request_id;
};
struct rmw_message_info_t {
  int64_t source_timestamp;
  int64_t received_timestamp;
  bool from_intra_process;
};
