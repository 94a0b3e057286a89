// SPDX-License-Identifier: Apache-2.0
// What asks: each request is answered when the node is spun, with nothing but default values where it is not observed.
#pragma once

#include <deque>
#include <future>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/qos.hpp"
#include "rosward_double/contents.hpp"
#include "rosward_double/core.hpp"
#include "rosward_double/messages.hpp"

namespace rclcpp
{
class ClientBase : public rosward_double::Entity
{
public:
  using SharedPtr = std::shared_ptr<ClientBase>;
  using WeakPtr = std::weak_ptr<ClientBase>;
  explicit ClientBase(std::string name) : name_(std::move(name)) {}
  const char * get_service_name() const { return name_.c_str(); }
  template<typename R = int64_t, typename P = std::milli>
  bool wait_for_service(std::chrono::duration<R, P> = std::chrono::duration<R, P>(-1))
  {
    return true;
  }
  bool service_is_ready() const { return true; }
  bool serve() override
  {
    if (pending_.empty() || answered_ == 8) {
      return false;
    }
    auto answer = std::move(pending_.front());
    pending_.pop_front();
    answered_++;
    answer();
    return true;
  }

protected:
  std::deque<std::function<void()>> pending_;

private:
  std::string name_;
  int answered_ = 0;
};

class GenericClient : public ClientBase
{
public:
  using SharedPtr = std::shared_ptr<GenericClient>;
  using ClientBase::ClientBase;
};

template<typename ServiceT>
class Client : public ClientBase
{
public:
  using SharedPtr = std::shared_ptr<Client>;
  using WeakPtr = std::weak_ptr<Client>;
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Promise = std::promise<SharedResponse>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;

  struct FutureAndRequestId
  {
    Future future;
    int64_t request_id;
    operator Future &() { return future; }  // NOLINT: implicit, as in rclcpp
    SharedResponse get() { return future.get(); }
    SharedFuture share() { return future.share(); }
    bool valid() const { return future.valid(); }
    void wait() const { future.wait(); }
    template<typename D>
    std::future_status wait_for(const D & time) const
    {
      return future.wait_for(time);
    }
  };
  struct SharedFutureAndRequestId
  {
    SharedFuture future;
    int64_t request_id;
    operator SharedFuture() const { return future; }  // NOLINT
    SharedResponse get() const { return future.get(); }
    bool valid() const { return future.valid(); }
    void wait() const { future.wait(); }
    template<typename D>
    std::future_status wait_for(const D & time) const
    {
      return future.wait_for(time);
    }
  };

  using ClientBase::ClientBase;

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    auto promise = std::make_shared<Promise>();
    pending_.push_back([promise, response = ask(*request)] { promise->set_value(response); });
    return {promise->get_future(), 1};
  }
  template<typename F>
  auto async_send_request(SharedRequest request, F && callback)
  {
    if constexpr (std::is_invocable_v<F &, SharedFuture>) {
      std::promise<SharedResponse> promise;
      SharedFuture future = promise.get_future().share();
      promise.set_value(ask(*request));
      pending_.push_back([future, callback = std::decay_t<F>(std::forward<F>(callback))]() mutable { callback(future); });
      return SharedFutureAndRequestId{future, 1};
    } else {
      std::promise<std::pair<SharedRequest, SharedResponse>> promise;
      SharedFutureWithRequest future = promise.get_future().share();
      promise.set_value({request, ask(*request)});
      pending_.push_back([future, callback = std::decay_t<F>(std::forward<F>(callback))]() mutable { callback(future); });
      return future;
    }
  }
  bool remove_pending_request(int64_t) { return true; }
  size_t prune_pending_requests() { return 0; }

private:
  // A request leaves; the answer that will arrive.
  SharedResponse ask(const Request & request)
  {
    rosward_double::leave(std::string("request:") + get_service_name(), request);
    auto response = std::make_shared<Response>();
    rosward_double::arrive(std::string("response:") + get_service_name(), asked_++, *response);
    return response;
  }
  int asked_ = 0;
};
}  // namespace rclcpp
