// SPDX-License-Identifier: Apache-2.0
// A double of rclcpp, written from its documentation: enough for small programs. It compiles quickly, and tells what is created.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/executors.hpp"
#include "rclcpp/free_functions.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/parameter_client.hpp"
#include "rclcpp/wait_set.hpp"

#define RCLCPP_VERSION_MAJOR 29
#define RCLCPP_VERSION_MINOR 3
#define RCLCPP_VERSION_PATCH 0
#define RCLCPP_VERSION_GTE(major, minor, patch) \
  (((major) < 29) || ((major) == 29 && ((minor) < 3 || ((minor) == 3 && (patch) <= 0))))
#define RCLCPP_SMART_PTR_DEFINITIONS(NAME) \
  ROSWARD_DOUBLE_POINTERS(NAME) \
  template<typename ... Args> \
  static std::shared_ptr<NAME> make_shared(Args && ... args) \
  { \
    return std::make_shared<NAME>(std::forward<Args>(args)...); \
  }
#define RCLCPP_SHARED_PTR_DEFINITIONS(NAME) RCLCPP_SMART_PTR_DEFINITIONS(NAME)
#define RCLCPP_UNIQUE_PTR_DEFINITIONS(NAME) using UniquePtr = std::unique_ptr<NAME>;
#define RCLCPP_DISABLE_COPY(NAME) \
  NAME(const NAME &) = delete; \
  NAME & operator=(const NAME &) = delete;

namespace rclcpp
{
void init(int argc, char const * const * argv, const InitOptions & = {}, SignalHandlerOptions = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(int argc, char const * const * argv, const InitOptions & = {});
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv);
bool ok(std::shared_ptr<Context> = nullptr);
bool shutdown(std::shared_ptr<Context> = nullptr, const std::string & = "");
bool install_signal_handlers();
bool uninstall_signal_handlers();
bool sleep_for(const std::chrono::nanoseconds &, std::shared_ptr<Context> = nullptr);
void on_shutdown(std::function<void()> callback, std::shared_ptr<Context> = nullptr);
std::string expand_topic_or_service_name(const std::string & name, const std::string & node, const std::string & space, bool is_service = false);
namespace contexts
{
std::shared_ptr<Context> get_global_default_context();
}
}  // namespace rclcpp
