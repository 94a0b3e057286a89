// SPDX-License-Identifier: Apache-2.0
// rclcpp: what of it is not in the headers beside this one? Small words.

namespace rclcpp
{
constexpr bool operator==(const rmw_qos_profile_t & left, const rmw_qos_profile_t & right);

namespace topic_statistics
{
constexpr const char * kDefaultPublishTopicName = "/statistics";
}

namespace allocator
{
template<typename T>
using Deleter = std::default_delete<T>;
}

namespace memory_strategy
{
class MemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MemoryStrategy)
};
}  // namespace memory_strategy
}  // namespace rclcpp
