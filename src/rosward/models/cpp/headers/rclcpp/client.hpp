// SPDX-License-Identifier: Apache-2.0
// rclcpp: what can be done with a client, and with a service?
//
// Read from rclcpp, branches humble, jazzy and rolling (client.hpp, service.hpp, generic_client.hpp, generic_service.hpp, future_return_code.hpp).

namespace rclcpp
{
enum class FutureReturnCode { SUCCESS, INTERRUPTED, TIMEOUT };
namespace executor
{
using FutureReturnCode = rclcpp::FutureReturnCode;
}

namespace detail
{
// What is there later: a response, or what else was asked for. It may be shared, so future and shared future are one.
template<typename ResultT>
class Future
{
public:
  Future() {}
  explicit Future(const ResultT & result) : _result(result) {}
  ResultT get() const {return _result;}
  bool valid() const {return true;}
  void wait() const {rosward::spin();}
  template<typename DurationT>
  std::future_status wait_for(const DurationT & timeout) const
  {
    return rosward::unknown("live", "whether an answer is there");
  }
  template<typename TimeT>
  std::future_status wait_until(const TimeT & time) const
  {
    return rosward::unknown("live", "whether an answer is there");
  }
  Future & share() {return *this;}

  ResultT _result;
};

template<typename ResultT>
class FutureAndRequestId : public Future<ResultT>
{
public:
  FutureAndRequestId() {}
  explicit FutureAndRequestId(const ResultT & result) : Future<ResultT>(result), future(result) {}

  Future<ResultT> future;
  int64_t request_id = 0;
};
}  // namespace detail

class ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ClientBase)
  virtual ~ClientBase() {}
  const char * get_service_name() const {return rosward::resolve_name(_node, _service, "service");}
  bool service_is_ready() const {return rosward::unknown("live", "whether a service is there", "bool");}
  template<typename DurationT = int>
  bool wait_for_service(const DurationT & timeout = -1)
  {
    return rosward::unknown("live", "whether a service is there", "bool");
  }
  template<typename CallbackT>
  void set_on_new_response_callback(CallbackT callback) {rosward::schedule(callback, "response", 1);}
  void clear_on_new_response_callback() {}
  size_t prune_pending_requests() {return 0;}
  template<typename T>
  bool remove_pending_request(const T & request) {return true;}

  rosward::value _node;
  std::string _service;
};

template<typename ServiceT>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Request = typename ServiceT::Request;
  using Response = typename ServiceT::Response;
  using SharedRequest = std::shared_ptr<typename ServiceT::Request>;
  using SharedResponse = std::shared_ptr<typename ServiceT::Response>;
  using Future = detail::Future<std::shared_ptr<typename ServiceT::Response>>;
  using SharedFuture = detail::Future<std::shared_ptr<typename ServiceT::Response>>;
  using FutureAndRequestId = detail::FutureAndRequestId<std::shared_ptr<typename ServiceT::Response>>;
  using SharedFutureAndRequestId = detail::FutureAndRequestId<std::shared_ptr<typename ServiceT::Response>>;
  using SharedFutureWithRequest =
    detail::Future<std::pair<std::shared_ptr<typename ServiceT::Request>, std::shared_ptr<typename ServiceT::Response>>>;
  using SharedFutureWithRequestAndRequestId =
    detail::FutureAndRequestId<std::pair<std::shared_ptr<typename ServiceT::Request>, std::shared_ptr<typename ServiceT::Response>>>;
  using CallbackType = std::function<void(SharedFuture)>;
  using CallbackWithRequestType = std::function<void(SharedFutureWithRequest)>;

  Client() {}

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    rosward::send("request", _node, _service, rosward::type<Request>(), request);
    return FutureAndRequestId(rosward::arrived<Response>());
  }
  template<typename CallbackT>
  SharedFutureAndRequestId async_send_request(SharedRequest request, CallbackT && callback)
  {
    rosward::send("request", _node, _service, rosward::type<Request>(), request);
    if (rosward::takes(callback, "SharedFutureWithRequest")) {
      SharedFutureWithRequest both(std::make_pair(request, rosward::arrived<Response>()));
      rosward::schedule(callback, "response", both);
    } else {
      SharedFuture future(rosward::arrived<Response>());
      rosward::schedule(callback, "response", future);
    }
    return SharedFutureAndRequestId(rosward::arrived<Response>());
  }
  bool take_response(Response & response_out, rmw_request_id_t & request_header_out)
  {
    rosward::fill(response_out);
    return rosward::unknown("live", "whether a response is there", "bool");
  }
  void configure_introspection(Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  {
    if (state != RCL_SERVICE_INTROSPECTION_OFF) {
      rosward::introspect("service_client", _node, _service, rosward::type<ServiceT>(), qos);
    }
  }
};

class GenericClient : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericClient)
  using Request = void *;
  using Response = void *;
  using SharedResponse = std::shared_ptr<void>;
  using Future = detail::Future<std::shared_ptr<void>>;
  using SharedFuture = detail::Future<std::shared_ptr<void>>;
  using FutureAndRequestId = detail::FutureAndRequestId<std::shared_ptr<void>>;

  FutureAndRequestId async_send_request(void * request)
  {
    rosward::send("request", _node, _service, _type, request);
    return FutureAndRequestId(rosward::unknown("message", "response"));
  }
  template<typename CallbackT>
  FutureAndRequestId async_send_request(void * request, CallbackT && callback)
  {
    rosward::send("request", _node, _service, _type, request);
    SharedFuture future(rosward::unknown("message", "response"));
    rosward::schedule(callback, "response", future);
    return FutureAndRequestId(rosward::unknown("message", "response"));
  }

  rosward::value _type;
};

class ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ServiceBase)
  virtual ~ServiceBase() {}
  const char * get_service_name() {return rosward::resolve_name(_node, _service, "service");}
  template<typename CallbackT>
  void set_on_new_request_callback(CallbackT callback) {rosward::schedule(callback, "service", 1);}
  void clear_on_new_request_callback() {}

  rosward::value _node;
  std::string _service;
};

template<typename ServiceT>
class Service : public ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service)
  Service() {}
  template<typename HeaderT>
  void send_response(HeaderT & request_id, typename ServiceT::Response & response)
  {
    rosward::send("response", _node, _service, rosward::type<typename ServiceT::Response>(), response);
  }
  bool take_request(typename ServiceT::Request & request_out, rmw_request_id_t & request_id_out)
  {
    rosward::fill(request_out);
    return rosward::unknown("live", "whether a request is there", "bool");
  }
  void configure_introspection(Clock::SharedPtr clock, const QoS & qos, rcl_service_introspection_state_t state)
  {
    if (state != RCL_SERVICE_INTROSPECTION_OFF) {
      rosward::introspect("service_server", _node, _service, rosward::type<ServiceT>(), qos);
    }
  }
};

class GenericService : public ServiceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericService)
  using SharedRequest = std::shared_ptr<void>;
  using SharedResponse = std::shared_ptr<void>;
};
}  // namespace rclcpp
