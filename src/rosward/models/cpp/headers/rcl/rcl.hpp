// SPDX-License-Identifier: Apache-2.0
// rcl: which words of its C interface do programs write?

enum rcl_clock_type_t { RCL_CLOCK_UNINITIALIZED = 0, RCL_ROS_TIME = 1, RCL_SYSTEM_TIME = 2, RCL_STEADY_TIME = 3 };
enum rcl_service_introspection_state_t {
  RCL_SERVICE_INTROSPECTION_OFF = 0,
  RCL_SERVICE_INTROSPECTION_METADATA = 1,
  RCL_SERVICE_INTROSPECTION_CONTENTS = 2
};
typedef int rcl_ret_t;
typedef int64_t rcl_time_point_value_t;
typedef int64_t rcl_duration_value_t;
const int RCL_RET_OK = 0;
const int RCL_RET_ERROR = 1;
const int RCL_RET_TIMEOUT = 2;

struct rcl_duration_t {
  int64_t nanoseconds = 0;
};

const rmw_qos_profile_t rcl_qos_profile_rosout_default = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000, RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL};
const rmw_qos_profile_t rcl_action_qos_profile_status_default = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL};
