// SPDX-License-Identifier: Apache-2.0
// rclcpp: which options are nodes, publishers and subscriptions made with?
//
// Read from rclcpp, branches humble, jazzy and rolling (node_options.hpp, publisher_options.hpp, subscription_options.hpp,
// subscription_content_filter_options.hpp, executor_options.hpp).

namespace rclcpp
{
enum class IntraProcessSetting { Enable, Disable, NodeDefault };
enum class IntraProcessBufferType { SharedPtr, UniquePtr, CallbackDefault };
enum class TopicStatisticsState { Enable, Disable, NodeDefault };

struct PublisherEventCallbacks
{
  std::function<void(QOSDeadlineOfferedInfo &)> deadline_callback;
  std::function<void(QOSLivelinessLostInfo &)> liveliness_callback;
  std::function<void(QOSOfferedIncompatibleQoSInfo &)> incompatible_qos_callback;
  std::function<void(IncompatibleTypeInfo &)> incompatible_type_callback;
  std::function<void(PublisherMatchedInfo &)> matched_callback;
};

struct SubscriptionEventCallbacks
{
  std::function<void(QOSDeadlineRequestedInfo &)> deadline_callback;
  std::function<void(QOSLivelinessChangedInfo &)> liveliness_callback;
  std::function<void(QOSRequestedIncompatibleQoSInfo &)> incompatible_qos_callback;
  std::function<void(QOSMessageLostInfo &)> message_lost_callback;
  std::function<void(IncompatibleTypeInfo &)> incompatible_type_callback;
  std::function<void(MatchedInfo &)> matched_callback;
};

struct PublisherOptionsBase
{
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::SharedPtr;
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints = 0;
  std::shared_ptr<CallbackGroup> callback_group;
  QosOverridingOptions qos_overriding_options;
};

template<typename Allocator>
struct PublisherOptionsWithAllocator : public PublisherOptionsBase
{
  std::shared_ptr<Allocator> allocator = nullptr;
  PublisherOptionsWithAllocator() {}
  explicit PublisherOptionsWithAllocator(const PublisherOptionsBase & base) : PublisherOptionsBase(base) {}
};
using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};

struct SubscriptionOptionsBase
{
  struct TopicStatisticsOptions
  {
    TopicStatisticsState state = TopicStatisticsState::NodeDefault;
    std::string publish_topic = "/statistics";
    std::chrono::milliseconds publish_period;
    QoS qos = QoS(10);
  };
  SubscriptionEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints = 0;
  std::shared_ptr<CallbackGroup> callback_group = nullptr;
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::CallbackDefault;
  TopicStatisticsOptions topic_stats_options;
  QosOverridingOptions qos_overriding_options;
  ContentFilterOptions content_filter_options;
};

template<typename Allocator>
struct SubscriptionOptionsWithAllocator : public SubscriptionOptionsBase
{
  std::shared_ptr<Allocator> allocator = nullptr;
  SubscriptionOptionsWithAllocator() {}
  explicit SubscriptionOptionsWithAllocator(const SubscriptionOptionsBase & base) : SubscriptionOptionsBase(base) {}
};
using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

namespace detail
{
void schedule_events(const PublisherEventCallbacks & callbacks)
{
  rosward::schedule(callbacks.deadline_callback, "event", rosward::unknown("live", "event of a publisher"));
  rosward::schedule(callbacks.liveliness_callback, "event", rosward::unknown("live", "event of a publisher"));
  rosward::schedule(callbacks.incompatible_qos_callback, "event", rosward::unknown("live", "event of a publisher"));
  rosward::schedule(callbacks.incompatible_type_callback, "event", rosward::unknown("live", "event of a publisher"));
  rosward::schedule(callbacks.matched_callback, "event", rosward::unknown("live", "event of a publisher"));
}
void schedule_events(const SubscriptionEventCallbacks & callbacks)
{
  rosward::schedule(callbacks.deadline_callback, "event", rosward::unknown("live", "event of a subscription"));
  rosward::schedule(callbacks.liveliness_callback, "event", rosward::unknown("live", "event of a subscription"));
  rosward::schedule(callbacks.incompatible_qos_callback, "event", rosward::unknown("live", "event of a subscription"));
  rosward::schedule(callbacks.message_lost_callback, "event", rosward::unknown("live", "event of a subscription"));
  rosward::schedule(callbacks.incompatible_type_callback, "event", rosward::unknown("live", "event of a subscription"));
  rosward::schedule(callbacks.matched_callback, "event", rosward::unknown("live", "event of a subscription"));
}
}  // namespace detail

class NodeOptions
{
public:
  NodeOptions() {}
  explicit NodeOptions(const rcl_allocator_t & allocator) {}
  // For models: options that are never without these words, so that those of several nodes, taken together, have them too.
  NodeOptions(const std::vector<std::string> & words, bool use_global_arguments)
  : arguments_(words), use_global_arguments_(use_global_arguments) {}

  std::shared_ptr<Context> context() const
  {
    return context_ == nullptr ? contexts::get_global_default_context() : context_;
  }
  NodeOptions & context(std::shared_ptr<Context> context)
  {
    context_ = context;
    return *this;
  }
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(const std::vector<std::string> & arguments)
  {
    arguments_ = arguments;
    return *this;
  }
  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  NodeOptions & parameter_overrides(const std::vector<Parameter> & parameter_overrides)
  {
    parameter_overrides_ = parameter_overrides;
    return *this;
  }
  template<typename ParameterT>
  NodeOptions & append_parameter_override(const std::string & name, const ParameterT & value)
  {
    parameter_overrides_.push_back(Parameter(name, value));
    return *this;
  }
  bool use_global_arguments() const {return use_global_arguments_;}
  NodeOptions & use_global_arguments(bool use_global_arguments)
  {
    use_global_arguments_ = use_global_arguments;
    return *this;
  }
  bool enable_rosout() const {return enable_rosout_;}
  NodeOptions & enable_rosout(bool enable_rosout)
  {
    enable_rosout_ = enable_rosout;
    return *this;
  }
  bool use_intra_process_comms() const {return use_intra_process_comms_;}
  NodeOptions & use_intra_process_comms(bool use_intra_process_comms)
  {
    use_intra_process_comms_ = use_intra_process_comms;
    return *this;
  }
  bool enable_topic_statistics() const {return enable_topic_statistics_;}
  NodeOptions & enable_topic_statistics(bool enable_topic_statistics)
  {
    enable_topic_statistics_ = enable_topic_statistics;
    return *this;
  }
  bool start_parameter_services() const {return start_parameter_services_;}
  NodeOptions & start_parameter_services(bool start_parameter_services)
  {
    start_parameter_services_ = start_parameter_services;
    return *this;
  }
  bool enable_logger_service() const {return enable_logger_service_;}
  NodeOptions & enable_logger_service(bool enable_logger_service)
  {
    enable_logger_service_ = enable_logger_service;
    return *this;
  }
  bool start_parameter_event_publisher() const {return start_parameter_event_publisher_;}
  NodeOptions & start_parameter_event_publisher(bool start_parameter_event_publisher)
  {
    start_parameter_event_publisher_ = start_parameter_event_publisher;
    return *this;
  }
  rcl_clock_type_t clock_type() const {return clock_type_;}
  NodeOptions & clock_type(const rcl_clock_type_t & clock_type)
  {
    clock_type_ = clock_type;
    return *this;
  }
  QoS clock_qos() const {return ClockQoS();}
  NodeOptions & clock_qos(const QoS & clock_qos) {return *this;}
  bool use_clock_thread() const {return use_clock_thread_;}
  NodeOptions & use_clock_thread(bool use_clock_thread)
  {
    use_clock_thread_ = use_clock_thread;
    return *this;
  }
  QoS parameter_event_qos() const {return ParameterEventsQoS();}
  NodeOptions & parameter_event_qos(const QoS & parameter_event_qos) {return *this;}
  QoS rosout_qos() const {return RosoutQoS();}
  NodeOptions & rosout_qos(const QoS & rosout_qos) {return *this;}
  PublisherOptionsBase parameter_event_publisher_options() const {return PublisherOptionsBase();}
  NodeOptions & parameter_event_publisher_options(const PublisherOptionsBase & options) {return *this;}
  bool allow_undeclared_parameters() const {return allow_undeclared_parameters_;}
  NodeOptions & allow_undeclared_parameters(bool allow_undeclared_parameters)
  {
    allow_undeclared_parameters_ = allow_undeclared_parameters;
    return *this;
  }
  bool automatically_declare_parameters_from_overrides() const {return automatically_declare_parameters_from_overrides_;}
  NodeOptions & automatically_declare_parameters_from_overrides(bool automatically_declare_parameters_from_overrides)
  {
    automatically_declare_parameters_from_overrides_ = automatically_declare_parameters_from_overrides;
    return *this;
  }
  NodeOptions & allocator(rcl_allocator_t allocator) {return *this;}

private:
  std::shared_ptr<Context> context_ = nullptr;
  std::vector<std::string> arguments_;
  std::vector<Parameter> parameter_overrides_;
  bool use_global_arguments_ = true;
  bool enable_rosout_ = true;
  bool use_intra_process_comms_ = false;
  bool enable_topic_statistics_ = false;
  bool start_parameter_services_ = true;
  bool start_parameter_event_publisher_ = true;
  bool enable_logger_service_ = false;
  bool use_clock_thread_ = true;
  bool allow_undeclared_parameters_ = false;
  bool automatically_declare_parameters_from_overrides_ = false;
  rcl_clock_type_t clock_type_ = RCL_ROS_TIME;
};

struct ExecutorOptions
{
  std::shared_ptr<Context> context;
  size_t max_conditions = 0;
};
}  // namespace rclcpp
