// SPDX-License-Identifier: Apache-2.0
// rclcpp::Node: what is a node, and what does each of its methods make?
//
// `AnyNode` has what `rclcpp::Node` and `rclcpp_lifecycle::LifecycleNode` have in common; all node interfaces of one are the node itself.
// `_node` is the node in the graph: of a sub-node, the one that it was made of. Read from rclcpp, branches humble, jazzy and rolling
// (node.hpp, node_impl.hpp, node.cpp, node_interfaces/*, create_*.hpp).

namespace rclcpp
{
namespace node_interfaces
{
class PreSetParametersCallbackHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PreSetParametersCallbackHandle)
  std::function<void(std::vector<Parameter> &)> callback;
};
class OnSetParametersCallbackHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)> callback;
};
class PostSetParametersCallbackHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle)
  std::function<void(const std::vector<Parameter> &)> callback;
};
}  // namespace node_interfaces

class TopicEndpointInfo {};

class Waitable
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Waitable)
  virtual ~Waitable() {}
  virtual size_t get_number_of_ready_subscriptions() {return 0;}
  virtual size_t get_number_of_ready_timers() {return 0;}
  virtual size_t get_number_of_ready_clients() {return 0;}
  virtual size_t get_number_of_ready_events() {return 0;}
  virtual size_t get_number_of_ready_services() {return 0;}
  virtual size_t get_number_of_ready_guard_conditions() {return 0;}
  template<typename WaitSetT>
  void add_to_wait_set(WaitSetT && wait_set) {}
  template<typename WaitSetT>
  bool is_ready(const WaitSetT & wait_set);
  virtual std::shared_ptr<void> take_data() {return nullptr;}
  virtual std::shared_ptr<void> take_data_by_entity_id(size_t id) {return nullptr;}
  virtual void set_on_ready_callback(std::function<void(size_t, int)> callback) {}
  virtual void clear_on_ready_callback() {}
};

class [[rosward::node_class]] AnyNode
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(AnyNode)
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using PreSetParametersCallbackType = std::function<void(std::vector<Parameter> &)>;
  using OnSetParametersCallbackType =
    std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)>;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
  using PostSetParametersCallbackType = std::function<void(const std::vector<Parameter> &)>;
  using CallbackGroupFunction = std::function<void(CallbackGroup::SharedPtr)>;

  AnyNode() {}
  AnyNode(const AnyNode & other, const std::string & sub_namespace)
  : _node(other._node), _options(other._options),
    _sub_namespace(other._sub_namespace.empty() ? sub_namespace : other._sub_namespace + "/" + sub_namespace)
  {}
  virtual ~AnyNode() {}

  void _create(
    const std::string & node_name, const std::string & namespace_, const NodeOptions & options, bool lifecycle = false,
    bool lifecycle_services = false)
  {
    _options = options;
    rosward::create_node(this, node_name, namespace_, options, options.context(), lifecycle, lifecycle_services);
    if (options.automatically_declare_parameters_from_overrides()) {
      rosward::declare_given(this);
    }
    rosward::declare_own(this);
  }

  // Names

  const char * get_name() const {return rosward::node_name(this);}
  const char * get_namespace() const {return rosward::node_namespace(this);}
  const char * get_fully_qualified_name() const {return rosward::node_fqn(this);}
  const std::string & get_sub_namespace() const {return _sub_namespace;}
  std::string get_effective_namespace() const
  {
    const std::string above = rosward::node_namespace(this);
    if (_sub_namespace.empty()) {
      return above;
    }
    return above == "/" ? "/" + _sub_namespace : above + "/" + _sub_namespace;
  }
  std::string resolve_topic_name(const std::string & name, bool only_expand = false) const
  {
    return rosward::resolve_name(this, name, "topic");
  }
  std::string resolve_service_name(const std::string & name, bool only_expand = false) const
  {
    return rosward::resolve_name(this, name, "service");
  }
  std::string resolve_topic_or_service_name(
    const std::string & name, bool is_service, bool only_expand = false) const
  {
    return rosward::resolve_name(this, name, is_service ? "service" : "topic");
  }
  std::string _extended(const std::string & name) const
  {
    if (_sub_namespace.empty() || name.front() == '/' || name.front() == '~') {
      return name;
    }
    return _sub_namespace + "/" + name;
  }

  Logger get_logger() const {return Logger(rosward::node_name(this));}
  const char * get_logger_name() const {return rosward::node_name(this);}
  const NodeOptions & get_node_options() const {return _options;}
  std::shared_ptr<Context> get_context() {return _options.context();}
  Clock::SharedPtr get_clock() const {return std::make_shared<Clock>(RCL_ROS_TIME);}
  [[rosward::source("clock")]] Time now() const {return Time();}
  bool get_use_intra_process_default() const {return _options.use_intra_process_comms();}
  bool get_enable_topic_statistics_default() const {return _options.enable_topic_statistics();}

  // Groups and timers

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType group_type, bool automatically_add_to_executor_with_node = true)
  {
    return std::make_shared<CallbackGroup>(group_type);
  }
  CallbackGroup::SharedPtr get_default_callback_group()
  {
    return std::make_shared<CallbackGroup>(CallbackGroupType::MutuallyExclusive);
  }
  void for_each_callback_group(const CallbackGroupFunction & func) {func(get_default_callback_group());}
  bool callback_group_in_node(CallbackGroup::SharedPtr group) {return true;}
  template<typename PeriodT, typename CallbackT>
  std::shared_ptr<WallTimer<CallbackT>> create_wall_timer(
    const PeriodT & period, CallbackT callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<WallTimer<CallbackT>>();
    rosward::schedule(callback, "timer", timer);
    return timer;
  }
  template<typename PeriodT, typename CallbackT>
  std::shared_ptr<GenericTimer<CallbackT>> create_timer(
    const PeriodT & period, CallbackT callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<GenericTimer<CallbackT>>();
    rosward::schedule(callback, "timer", timer);
    return timer;
  }
  void add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr group = nullptr) {}
  template<typename WaitableT>
  void add_waitable(WaitableT waitable, CallbackGroup::SharedPtr group = nullptr)
  {
    rosward::schedule(
      [waitable]() {
        waitable->is_ready(rosward::unknown("live", "what is ready"));
        auto data = waitable->take_data();
        waitable->execute(data);
      },
      "waitable");
  }
  template<typename WaitableT>
  void remove_waitable(WaitableT waitable, CallbackGroup::SharedPtr group = nullptr) {}

  // Topics and services

  template<typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
    typename SubscriptionT = Subscription<MessageT>>
  [[rosward::creator]] std::shared_ptr<SubscriptionT> create_subscription(
    const std::string & topic_name, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options = SubscriptionOptions(), std::shared_ptr<void> strategy = nullptr)
  {
    return _subscribe<MessageT, SubscriptionT>(_extended(topic_name), qos, callback, options);
  }
  template<typename CallbackT, typename AllocatorT = std::allocator<void>>
  [[rosward::creator]] std::shared_ptr<GenericSubscription> create_generic_subscription(
    const std::string & topic_name, const std::string & topic_type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options = SubscriptionOptions())
  {
    return _subscribe_generic(_extended(topic_name), topic_type, qos, callback, options);
  }
  template<typename AllocatorT = std::allocator<void>>
  [[rosward::creator]] std::shared_ptr<GenericPublisher> create_generic_publisher(
    const std::string & topic_name, const std::string & topic_type, const QoS & qos,
    const PublisherOptions & options = PublisherOptions())
  {
    return _publish_generic(_extended(topic_name), topic_type, qos, options);
  }
  template<typename ServiceT, typename QosT = QoS>
  [[rosward::creator]] std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & service_name, const QosT & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    return _create_client<ServiceT>(_extended(service_name), qos);
  }
  template<typename ServiceT, typename CallbackT, typename QosT = QoS>
  [[rosward::creator]] std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & service_name, CallbackT && callback, const QosT & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    return _create_service<ServiceT>(_extended(service_name), callback, qos);
  }
  [[rosward::creator]] std::shared_ptr<GenericClient> create_generic_client(
    const std::string & service_name, const std::string & service_type, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    return _create_generic_client(_extended(service_name), service_type, qos);
  }
  template<typename CallbackT>
  [[rosward::creator]] std::shared_ptr<GenericService> create_generic_service(
    const std::string & service_name, const std::string & service_type, CallbackT && callback,
    const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    return _create_generic_service(_extended(service_name), service_type, callback, qos);
  }

  // The same for a name that no sub-node extends: what the free functions call

  template<typename MessageT, typename PublisherT>
  std::shared_ptr<PublisherT> _advertise(const std::string & name, const QoS & qos, const PublisherOptions & options)
  {
    detail::declare_qos_parameters(this, "publisher", name, qos, options.qos_overriding_options);
    detail::schedule_events(options.event_callbacks);
    rosward::create("publisher", _node, name, detail::wire_type<MessageT>(), qos);
    auto publisher = std::make_shared<PublisherT>();
    publisher->_node = _node;
    publisher->_topic = name;
    publisher->_qos = qos;
    return publisher;
  }
  std::shared_ptr<GenericPublisher> _publish_generic(
    const std::string & name, const std::string & type, const QoS & qos, const PublisherOptions & options)
  {
    detail::declare_qos_parameters(this, "publisher", name, qos, options.qos_overriding_options);
    detail::schedule_events(options.event_callbacks);
    rosward::create("publisher", _node, name, rosward::type_named(type), qos);
    auto publisher = std::make_shared<GenericPublisher>();
    publisher->_node = _node;
    publisher->_topic = name;
    publisher->_qos = qos;
    publisher->_type = rosward::type_named(type);
    return publisher;
  }
  template<typename MessageT, typename SubscriptionT, typename CallbackT>
  std::shared_ptr<SubscriptionT> _subscribe(
    const std::string & name, const QoS & qos, CallbackT && callback, const SubscriptionOptions & options)
  {
    _with_options(name, qos, options);
    rosward::create("subscription", _node, name, detail::wire_type<MessageT>(), qos, callback);
    rosward::deliver(callback, detail::custom_type<MessageT>());
    auto subscription = std::make_shared<SubscriptionT>();
    subscription->_node = _node;
    subscription->_topic = name;
    subscription->_qos = qos;
    return subscription;
  }
  template<typename CallbackT>
  std::shared_ptr<GenericSubscription> _subscribe_generic(
    const std::string & name, const std::string & type, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options)
  {
    _with_options(name, qos, options);
    rosward::create("subscription", _node, name, rosward::type_named(type), qos, callback);
    rosward::schedule(callback, "message", std::make_shared<SerializedMessage>(), MessageInfo());
    auto subscription = std::make_shared<GenericSubscription>();
    subscription->_node = _node;
    subscription->_topic = name;
    subscription->_qos = qos;
    return subscription;
  }
  void _with_options(const std::string & name, const QoS & qos, const SubscriptionOptions & options)
  {
    detail::declare_qos_parameters(this, "subscription", name, qos, options.qos_overriding_options);
    detail::schedule_events(options.event_callbacks);
    auto & statistics = options.topic_stats_options;
    if (
      statistics.state == TopicStatisticsState::Enable ||
      (statistics.state == TopicStatisticsState::NodeDefault && _options.enable_topic_statistics()))
    {
      rosward::create(
        "publisher", _node, statistics.publish_topic, rosward::type<statistics_msgs::msg::MetricsMessage>(),
        statistics.qos);
    }
  }
  template<typename ServiceT, typename QosT>
  std::shared_ptr<Client<ServiceT>> _create_client(const std::string & name, const QosT & qos)
  {
    rosward::create("service_client", _node, name, rosward::type<ServiceT>(), qos);
    auto client = std::make_shared<Client<ServiceT>>();
    client->_node = _node;
    client->_service = name;
    return client;
  }
  template<typename ServiceT, typename CallbackT, typename QosT>
  std::shared_ptr<Service<ServiceT>> _create_service(const std::string & name, CallbackT && callback, const QosT & qos)
  {
    rosward::create("service_server", _node, name, rosward::type<ServiceT>(), qos, callback);
    auto service = std::make_shared<Service<ServiceT>>();
    service->_node = _node;
    service->_service = name;
    rosward::serve(callback, service, _node, name, rosward::type<ServiceT>());
    return service;
  }
  std::shared_ptr<GenericClient> _create_generic_client(
    const std::string & name, const std::string & type, const QoS & qos)
  {
    rosward::create("service_client", _node, name, rosward::type_named(type), qos);
    auto client = std::make_shared<GenericClient>();
    client->_node = _node;
    client->_service = name;
    client->_type = rosward::type_named(type);
    return client;
  }
  template<typename CallbackT>
  std::shared_ptr<GenericService> _create_generic_service(
    const std::string & name, const std::string & type, CallbackT && callback, const QoS & qos)
  {
    rosward::create("service_server", _node, name, rosward::type_named(type), qos, callback);
    auto service = std::make_shared<GenericService>();
    service->_node = _node;
    service->_service = name;
    rosward::serve(callback, service, _node, name, rosward::type_named(type));
    return service;
  }

  // Parameters

  template<typename ParameterT, typename DescriptorT = int>
  auto declare_parameter(
    const std::string & name, const ParameterT & default_value = rosward::nothing(),
    const DescriptorT & descriptor = rosward::nothing(), bool ignore_override = false)
  {
    auto declared = rosward::declare_parameter<ParameterT>(_node, name, default_value, descriptor, ignore_override);
    if (rosward::is_plain<ParameterT>()) {
      return declared;
    }
    return ParameterValue(declared);
  }
  template<typename ParameterT>
  auto declare_parameters(
    const std::string & namespace_, const std::map<std::string, ParameterT> & parameters, bool ignore_overrides = false)
  {
    std::vector<ParameterT> result;
    for (const auto & entry : parameters) {
      const std::string name = namespace_.empty() ? entry.first : namespace_ + "." + entry.first;
      result.push_back(
        rosward::declare_parameter<ParameterT>(
          _node, name, rosward::default_in(entry.second), rosward::nothing(), ignore_overrides));
    }
    return result;
  }
  void undeclare_parameter(const std::string & name) {rosward::undeclare_parameter(_node, name);}
  bool has_parameter(const std::string & name) const {return rosward::has_parameter(_node, name);}

  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter)
  {
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = rosward::set_parameter(_node, parameter.get_name(), parameter._value);
    return result;
  }
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    std::vector<rcl_interfaces::msg::SetParametersResult> results;
    for (const auto & parameter : parameters) {
      results.push_back(set_parameter(parameter));
    }
    return results;
  }
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(const std::vector<Parameter> & parameters)
  {
    rcl_interfaces::msg::SetParametersResult result;
    result.successful = true;
    for (const auto & parameter : parameters) {
      result.successful = set_parameter(parameter).successful && result.successful;
    }
    return result;
  }

  Parameter get_parameter(const std::string & name) const
  {
    return Parameter(name, rosward::parameter(_node, name));
  }
  template<typename ParameterT>
  bool get_parameter(const std::string & name, ParameterT & parameter) const
  {
    return rosward::get_parameter(_node, _extended_parameter(name), parameter);
  }
  bool get_parameter(const std::string & name, Parameter & parameter) const
  {
    if (rosward::has_parameter(_node, name)) {
      parameter = Parameter(name, rosward::parameter(_node, name));
      return true;
    }
    return false;
  }
  template<typename ParameterT>
  bool get_parameter_or(const std::string & name, ParameterT & parameter, const ParameterT & alternative_value) const
  {
    const std::string extended = _extended_parameter(name);
    if (rosward::is_given(_node, extended)) {
      if (rosward::get_parameter(_node, extended, parameter)) {
        return true;
      }
    }
    if (rosward::lacks_parameter(_node, extended)) {
      parameter = alternative_value;
      return false;
    }
    parameter = rosward::default_of("parameter", extended, alternative_value);
    return rosward::unknown("parameter", "whether it is declared", "bool");
  }
  template<typename ParameterT>
  ParameterT get_parameter_or(const std::string & name, const ParameterT & alternative_value) const
  {
    ParameterT parameter = alternative_value;
    get_parameter_or(name, parameter, alternative_value);
    return parameter;
  }
  std::string _extended_parameter(const std::string & name) const
  {
    return _sub_namespace.empty() ? name : _sub_namespace + "/" + name;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const
  {
    std::vector<Parameter> parameters;
    for (const auto & name : names) {
      parameters.push_back(get_parameter(name));
    }
    return parameters;
  }
  template<typename ParameterT>
  bool get_parameters(const std::string & prefix, std::map<std::string, ParameterT> & values) const
  {
    return rosward::get_parameters(_node, prefix, values);
  }
  bool get_parameters_by_prefix(const std::string & prefix, std::map<std::string, Parameter> & parameters) const
  {
    std::map<std::string, rosward::value> found;
    rosward::get_parameters(_node, prefix, found);
    for (const auto & entry : found) {
      parameters[entry.first] = Parameter(prefix + "." + entry.first, entry.second);
    }
    return !found.empty();
  }
  rcl_interfaces::msg::ParameterDescriptor describe_parameter(const std::string & name) const
  {
    rosward::needs_parameter(_node, name, "describe_parameter");
    return rosward::message<rcl_interfaces::msg::ParameterDescriptor>();
  }
  std::vector<rcl_interfaces::msg::ParameterDescriptor> describe_parameters(const std::vector<std::string> & names) const
  {
    std::vector<rcl_interfaces::msg::ParameterDescriptor> found;
    for (const auto & name : names) {
      found.push_back(describe_parameter(name));
    }
    return found;
  }
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string> & names) const
  {
    std::vector<uint8_t> found;
    for (const auto & name : names) {
      found.push_back(rosward::parameter_type(rosward::parameter(_node, name)));
    }
    return found;
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
    const std::vector<std::string> & prefixes, uint64_t depth) const
  {
    if (prefixes.size() != 1) {  // of several, they come in one order
      return rosward::message<rcl_interfaces::msg::ListParametersResult>();
    }
    const std::string & prefix = prefixes.front();
    std::map<std::string, rosward::value> found;
    rosward::get_whole_parameters(_node, prefix, found);
    rcl_interfaces::msg::ListParametersResult listed;
    if (has_parameter(prefix)) {
      _list(prefix, listed);
    }
    for (const auto & each : found) {
      const std::string below = each.first.substr(prefix.size() + 1);
      const size_t dots = std::count(below.begin(), below.end(), '.');
      if (depth == 0 || dots < depth) {
        _list(each.first, listed);
      }
    }
    return listed;
  }
  static void _list(const std::string & name, rcl_interfaces::msg::ListParametersResult & listed)
  {
    listed.names.push_back(name);
    const auto last = name.rfind('.');
    if (last == std::string::npos) {
      return;
    }
    const std::string above = name.substr(0, last);
    if (std::find(listed.prefixes.begin(), listed.prefixes.end(), above) == listed.prefixes.end()) {
      listed.prefixes.push_back(above);
    }
  }
  auto get_parameter_overrides() const
  {
    return rosward::given_parameters<std::map<std::string, ParameterValue>, ParameterValue>(_node);
  }

  template<typename CallbackT>
  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(CallbackT callback)
  {
    rosward::may_refuse(_node);
    rosward::schedule(callback, "parameters", detail::new_parameters());
    return std::make_shared<PreSetParametersCallbackHandle>();
  }
  template<typename CallbackT>
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(CallbackT callback)
  {
    rosward::may_refuse(_node);
    rosward::schedule(callback, "parameters", detail::new_parameters());
    return std::make_shared<OnSetParametersCallbackHandle>();
  }
  template<typename CallbackT>
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(CallbackT callback)
  {
    rosward::schedule(callback, "parameters", detail::new_parameters());
    return std::make_shared<PostSetParametersCallbackHandle>();
  }
  template<typename CallbackT>
  OnParametersSetCallbackType set_on_parameters_set_callback(CallbackT callback)
  {
    add_on_set_parameters_callback(callback);
    return nullptr;
  }
  template<typename HandleT>
  void remove_pre_set_parameters_callback(HandleT handle) {}
  template<typename HandleT>
  void remove_on_set_parameters_callback(HandleT handle) {}
  template<typename HandleT>
  void remove_post_set_parameters_callback(HandleT handle) {}

  // The running system, which nobody knows before it runs

  std::vector<std::string> get_node_names() const {return rosward::unknown("live", "nodes of the system");}
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const
  {
    return rosward::unknown("live", "nodes of the system");
  }
  std::map<std::string, std::vector<std::string>> get_topic_names_and_types(bool no_demangle = false) const
  {
    return rosward::unknown("live", "topics of the system");
  }
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const
  {
    return rosward::unknown("live", "services of the system");
  }
  std::map<std::string, std::vector<std::string>> get_service_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_) const
  {
    return rosward::unknown("live", "services of a node");
  }
  std::map<std::string, std::vector<std::string>> get_client_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_) const
  {
    return rosward::unknown("live", "service clients of a node");
  }
  std::map<std::string, std::vector<std::string>> get_publisher_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_, bool no_demangle = false) const
  {
    return rosward::unknown("live", "publishers of a node");
  }
  std::map<std::string, std::vector<std::string>> get_subscriber_names_and_types_by_node(
    const std::string & node_name, const std::string & namespace_, bool no_demangle = false) const
  {
    return rosward::unknown("live", "subscriptions of a node");
  }
  size_t count_publishers(const std::string & topic_name) const {return rosward::unknown("live", "publishers of a topic", "int");}
  size_t count_subscribers(const std::string & topic_name) const {return rosward::unknown("live", "subscriptions of a topic", "int");}
  size_t count_clients(const std::string & service_name) const {return rosward::unknown("live", "clients of a service", "int");}
  size_t count_services(const std::string & service_name) const {return rosward::unknown("live", "servers of a service", "int");}
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(const std::string & topic_name, bool no_mangle = false) const
  {
    return rosward::unknown("live", "publishers of a topic");
  }
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(const std::string & topic_name, bool no_mangle = false) const
  {
    return rosward::unknown("live", "subscriptions of a topic");
  }
  Event::SharedPtr get_graph_event() {return std::make_shared<Event>();}
  template<typename TimeoutT>
  void wait_for_graph_change(Event::SharedPtr event, TimeoutT timeout) {}

  // Node interfaces: each is the node

  AnyNode * get_node_base_interface() const {return _node;}
  AnyNode * get_node_clock_interface() const {return _node;}
  AnyNode * get_node_graph_interface() const {return _node;}
  AnyNode * get_node_logging_interface() const {return _node;}
  AnyNode * get_node_timers_interface() const {return _node;}
  AnyNode * get_node_topics_interface() const {return _node;}
  AnyNode * get_node_services_interface() const {return _node;}
  AnyNode * get_node_waitables_interface() const {return _node;}
  AnyNode * get_node_parameters_interface() const {return _node;}
  AnyNode * get_node_time_source_interface() const {return _node;}
  AnyNode * get_node_type_descriptions_interface() const {return _node;}

  AnyNode * _node = this;
  NodeOptions _options;
  std::string _sub_namespace;
};

namespace detail
{
// What a callback for parameters sees: any number of them, of any name and value.
std::vector<Parameter> new_parameters()
{
  std::vector<Parameter> parameters;
  while (rosward::unknown("parameter", "set when it runs", "bool")) {
    parameters.push_back(
      Parameter(
        rosward::unknown("parameter", "name, set when it runs", "str"),
        rosward::unknown("parameter", "value, set when it runs")));
  }
  return parameters;
}
}  // namespace detail

class [[rosward::node_class]] Node : public AnyNode, public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)

  explicit Node(const std::string & node_name, const NodeOptions & options = NodeOptions())
  {
    _create(node_name, "", options);
  }
  explicit Node(
    const std::string & node_name, const std::string & namespace_, const NodeOptions & options = NodeOptions())
  {
    _create(node_name, namespace_, options);
  }
  virtual ~Node() {}

  template<typename MessageT, typename AllocatorT = std::allocator<void>, typename PublisherT = Publisher<MessageT>>
  [[rosward::creator]] std::shared_ptr<PublisherT> create_publisher(
    const std::string & topic_name, const QoS & qos, const PublisherOptions & options = PublisherOptions())
  {
    return _advertise<MessageT, PublisherT>(_extended(topic_name), qos, options);
  }
  Node::SharedPtr create_sub_node(const std::string & sub_namespace)
  {
    return std::shared_ptr<Node>(new Node(*this, sub_namespace));
  }

protected:
  Node() {}
  Node(const Node & other, const std::string & sub_namespace) : AnyNode(other, sub_namespace) {}
};

// What is taken for a node, because entities are created on it: its class is not among the sources, or nothing is known of it at all.
class AssumedNode : public Node
{
public:
  explicit AssumedNode(rosward::value node) {_node = node;}
};
}  // namespace rclcpp
