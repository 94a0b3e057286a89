// SPDX-License-Identifier: Apache-2.0
// rclcpp_lifecycle: a node whose transitions may be asked for at any time, in any order.
//
// Read from rclcpp_lifecycle, branches humble, jazzy and rolling (lifecycle_node.hpp, lifecycle_publisher.hpp, managed_entity.hpp, state.hpp,
// transition.hpp, lifecycle_node_interface.hpp).

namespace rclcpp_lifecycle
{
class State
{
public:
  State() {}
  explicit State(uint8_t id, const std::string & label = "") : _id(id), _label(label) {}
  uint8_t id() const {return _id;}
  std::string label() const {return _label;}

  uint8_t _id = 0;
  std::string _label;
};

class Transition
{
public:
  Transition() {}
  explicit Transition(uint8_t id, const std::string & label = "") : _id(id), _label(label) {}
  uint8_t id() const {return _id;}
  std::string label() const {return _label;}
  State start_state() const {return State();}
  State goal_state() const {return State();}

  uint8_t _id = 0;
  std::string _label;
};

class ManagedEntityInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ManagedEntityInterface)
  virtual ~ManagedEntityInterface() {}
  virtual void on_activate() {}
  virtual void on_deactivate() {}
};

class SimpleManagedEntity : public ManagedEntityInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SimpleManagedEntity)
  void on_activate() override {}
  void on_deactivate() override {}
  bool is_activated() const {return rosward::unknown("live", "whether the node is active", "bool");}
};

class LifecyclePublisherInterface : public SimpleManagedEntity {};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<MessageT, AllocatorT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher)
  using MessageUniquePtr = std::unique_ptr<MessageT>;
  LifecyclePublisher() {}
};

namespace node_interfaces
{
class LifecycleNodeInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNodeInterface)
  enum class CallbackReturn { SUCCESS = 97, FAILURE = 98, ERROR = 99 };

  virtual ~LifecycleNodeInterface() {}
  virtual CallbackReturn on_configure(const State & previous_state) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_cleanup(const State & previous_state) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_shutdown(const State & previous_state) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State & previous_state) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_deactivate(const State & previous_state) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_error(const State & previous_state) {return CallbackReturn::SUCCESS;}
};
}  // namespace node_interfaces

class [[rosward::node_class]] LifecycleNode
: public node_interfaces::LifecycleNodeInterface, public rclcpp::AnyNode, public std::enable_shared_from_this<LifecycleNode>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)

  explicit LifecycleNode(
    const std::string & node_name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(),
    bool enable_communication_interface = true)
  {
    _begin(node_name, "", options, enable_communication_interface);
  }
  LifecycleNode(
    const std::string & node_name, const std::string & namespace_,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions(), bool enable_communication_interface = true)
  {
    _begin(node_name, namespace_, options, enable_communication_interface);
  }
  virtual ~LifecycleNode() {}

  // What the services of the node call; without them only the node itself does, by `trigger_transition`.
  void _begin(
    const std::string & node_name, const std::string & namespace_, const rclcpp::NodeOptions & options, bool services)
  {
    _create(node_name, namespace_, options, true, services);
    if (services) {
      rosward::schedule([this]() {_configure();}, "transition");
      rosward::schedule([this]() {_cleanup();}, "transition");
      rosward::schedule([this]() {_shutdown();}, "transition");
      rosward::schedule([this]() {_activate();}, "transition");
      rosward::schedule([this]() {_deactivate();}, "transition");
    }
    rosward::schedule([this](State state) {on_error(state);}, "transition", _some_state());
  }
  // A transition is the same, whoever asks for it: what it makes is told apart by the node alone.
  [[rosward::apart]] void _configure() {on_configure(State(1, "unconfigured"));}
  [[rosward::apart]] void _cleanup() {on_cleanup(State(2, "inactive"));}
  [[rosward::apart]] void _shutdown() {on_shutdown(_some_state());}
  [[rosward::apart]] void _activate() {on_activate(State(2, "inactive"));}
  [[rosward::apart]] void _deactivate() {on_deactivate(State(3, "active"));}
  State _some_state() const
  {
    return State(
      rosward::unknown("live", "state of the node", "int"), rosward::unknown("live", "state of the node", "str"));
  }

  template<typename MessageT, typename AllocatorT = std::allocator<void>>
  [[rosward::creator]] std::shared_ptr<LifecyclePublisher<MessageT>> create_publisher(
    const std::string & topic_name, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptions & options = rclcpp::PublisherOptions())
  {
    return _advertise<MessageT, LifecyclePublisher<MessageT>>(_extended(topic_name), qos, options);
  }

  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> managed_entity) {}
  void add_timer_handle(std::shared_ptr<rclcpp::TimerBase> timer) {}
  State get_current_state() const {return _some_state();}
  std::vector<State> get_available_states() const {return rosward::unknown("live", "states of the node");}
  std::vector<Transition> get_available_transitions() const {return rosward::unknown("live", "transitions of the node");}
  std::vector<Transition> get_transition_graph() const {return rosward::unknown("live", "transitions of the node");}

  template<typename... ArgsT>
  State trigger_transition(const ArgsT & ... args)
  {
    configure();
    activate();
    deactivate();
    cleanup();
    return shutdown();
  }
  template<typename... ArgsT>
  State configure(const ArgsT & ... args)
  {
    _configure();
    return _some_state();
  }
  template<typename... ArgsT>
  State cleanup(const ArgsT & ... args)
  {
    _cleanup();
    return _some_state();
  }
  template<typename... ArgsT>
  State activate(const ArgsT & ... args)
  {
    _activate();
    return _some_state();
  }
  template<typename... ArgsT>
  State deactivate(const ArgsT & ... args)
  {
    _deactivate();
    return _some_state();
  }
  template<typename... ArgsT>
  State shutdown(const ArgsT & ... args)
  {
    _shutdown();
    return _some_state();
  }

  // A function in place of the method: both may run

  template<typename CallbackT>
  bool register_on_configure(CallbackT callback) {return _register(callback, State(1, "unconfigured"));}
  template<typename CallbackT>
  bool register_on_cleanup(CallbackT callback) {return _register(callback, State(2, "inactive"));}
  template<typename CallbackT>
  bool register_on_shutdown(CallbackT callback) {return _register(callback, _some_state());}
  template<typename CallbackT>
  bool register_on_activate(CallbackT callback) {return _register(callback, State(2, "inactive"));}
  template<typename CallbackT>
  bool register_on_deactivate(CallbackT callback) {return _register(callback, State(3, "active"));}
  template<typename CallbackT>
  bool register_on_error(CallbackT callback) {return _register(callback, _some_state());}
  template<typename CallbackT>
  bool _register(CallbackT callback, const State & state)
  {
    rosward::schedule(callback, "transition", state);
    return true;
  }
};
}  // namespace rclcpp_lifecycle
