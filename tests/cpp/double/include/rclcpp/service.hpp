// SPDX-License-Identifier: Apache-2.0
// What answers: twice a request with nothing but default values.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/qos.hpp"
#include "rosward_double/contents.hpp"
#include "rosward_double/core.hpp"
#include "rosward_double/messages.hpp"

struct rmw_request_id_t
{
  int64_t sequence_number = 0;
};

namespace rclcpp
{
class ServiceBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<ServiceBase>;
  explicit ServiceBase(std::string name) : name_(std::move(name)) {}
  const char * get_service_name() const { return name_.c_str(); }
  bool serve() override
  {
    if (!callback || !turn()) {
      return false;
    }
    callback();
    return true;
  }
  std::function<void()> callback;

private:
  std::string name_;
};

template<typename ServiceT>
class Service : public ServiceBase, public std::enable_shared_from_this<Service<ServiceT>>
{
public:
  using SharedPtr = std::shared_ptr<Service>;
  using WeakPtr = std::weak_ptr<Service>;
  using ServiceBase::ServiceBase;
  void send_response(rmw_request_id_t &, typename ServiceT::Response & response) { leave(response); }
  template<typename F>
  void take(F given)
  {
    callback = [this, given = std::move(given)]() mutable {
        using Request = typename ServiceT::Request;
        using Response = typename ServiceT::Response;
        auto header = std::make_shared<rmw_request_id_t>();
        auto request = std::make_shared<Request>();
        auto response = std::make_shared<Response>();
        rosward_double::arrive(std::string("service:") + this->get_service_name(), this->turns(), *request);
        if constexpr (std::is_invocable_v<F &, decltype(request), decltype(response)>) {
          given(request, response);
          leave(*response);
        } else if constexpr (std::is_invocable_v<F &, decltype(header), decltype(request)>) {
          given(header, request);
        } else if constexpr (std::is_invocable_v<F &, decltype(header), decltype(request), decltype(response)>) {
          given(header, request, response);
          leave(*response);
        } else {
          given(this->shared_from_this(), header, request);
        }
      };
  }

private:
  void leave(const typename ServiceT::Response & response) { rosward_double::leave(std::string("response:") + this->get_service_name(), response); }
};
}  // namespace rclcpp
