// SPDX-License-Identifier: Apache-2.0
// controller_interface: a controller is loaded by the controller manager, which gives it a node of a name from outside.
//
// Read from ros-controls/ros2_control, branches humble to master (controller_interface/include/controller_interface/*).

namespace controller_interface
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
enum class return_type { OK = 0, ERROR = 1 };
enum class interface_configuration_type { ALL = 0, INDIVIDUAL = 1, NONE = 2, INDIVIDUAL_BEST_EFFORT = 3 };
struct InterfaceConfiguration
{
  interface_configuration_type type = interface_configuration_type::NONE;
  std::vector<std::string> names;
};

class ControllerInterfaceBase : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ControllerInterfaceBase)
  ControllerInterfaceBase() {}
  virtual ~ControllerInterfaceBase() {}
  virtual InterfaceConfiguration command_interface_configuration() const {return InterfaceConfiguration();}
  virtual InterfaceConfiguration state_interface_configuration() const {return InterfaceConfiguration();}
  virtual CallbackReturn on_init() {return CallbackReturn::SUCCESS;}
  virtual return_type update(const rclcpp::Time & time, const rclcpp::Duration & period) {return return_type::OK;}
  virtual rclcpp::NodeOptions define_custom_node_options() const
  {
#if RCLCPP_VERSION_GTE(21, 0, 0)
    return rclcpp::NodeOptions().enable_logger_service(true);
#else
    return rclcpp::NodeOptions().allow_undeclared_parameters(true).automatically_declare_parameters_from_overrides(true);
#endif
  }

  template<typename... ArgsT>
  return_type init(const std::string & controller_name, const ArgsT & ... args)
  {
    _start(controller_name, define_custom_node_options());
    return return_type::OK;
  }
  // What the controller manager does with a controller: it makes its node and asks for transitions.
  void _start(const std::string & controller_name, const rclcpp::NodeOptions & options)
  {
    _controller_node = std::make_shared<rclcpp_lifecycle::LifecycleNode>(controller_name, options, false);
    auto_declare<int>("update_rate", get_update_rate());
#if RCLCPP_VERSION_GTE(21, 0, 0)
    auto_declare<bool>("is_async", false);
#endif
    on_init();
    command_interface_configuration();
    state_interface_configuration();
    rosward::schedule([this](rclcpp_lifecycle::State state) {on_configure(state);}, "transition", rclcpp_lifecycle::State(1, "unconfigured"));
    rosward::schedule([this](rclcpp_lifecycle::State state) {on_activate(state);}, "transition", rclcpp_lifecycle::State(2, "inactive"));
    rosward::schedule([this](rclcpp_lifecycle::State state) {on_deactivate(state);}, "transition", rclcpp_lifecycle::State(3, "active"));
    rosward::schedule([this](rclcpp_lifecycle::State state) {on_cleanup(state);}, "transition", rclcpp_lifecycle::State(2, "inactive"));
    rosward::schedule([this](rclcpp_lifecycle::State state) {on_shutdown(state);}, "transition", rclcpp_lifecycle::State(2, "inactive"));
    rosward::schedule([this]() {update(rclcpp::Time(), rclcpp::Duration(0, 0));}, "timer");
  }
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() const {return _controller_node;}
  template<typename ParameterT>
  auto auto_declare(const std::string & name, const ParameterT & default_value)
  {
    if (!get_node()->has_parameter(name)) {
      return get_node()->template declare_parameter<ParameterT>(name, default_value);
    }
    return get_node()->get_parameter(name).template get_value<ParameterT>();
  }
  rclcpp_lifecycle::State get_lifecycle_state() const {return _controller_node->get_current_state();}
  rclcpp_lifecycle::State get_state() const {return _controller_node->get_current_state();}
  unsigned int get_update_rate() const {return rosward::unknown("parameter", "update_rate", "int");}
  const std::string & get_robot_description() const {return rosward::unknown("parameter", "robot_description", "str");}
  bool is_async() const {return false;}

  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> _controller_node;
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;
};

class ControllerInterface : public ControllerInterfaceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ControllerInterface)
};
class ChainableControllerInterface : public ControllerInterfaceBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ChainableControllerInterface)
  virtual return_type update_reference_from_subscribers(const rclcpp::Time & time, const rclcpp::Duration & period)
  {
    return return_type::OK;
  }
  virtual return_type update_and_write_commands(const rclcpp::Time & time, const rclcpp::Duration & period)
  {
    return return_type::OK;
  }
  return_type update(const rclcpp::Time & time, const rclcpp::Duration & period) override
  {
    update_reference_from_subscribers(time, period);
    return update_and_write_commands(time, period);
  }
};

// What the controller manager does with a class that it loads. The node has its name from outside: `-r __node:=…`.
template<typename ControllerT>
void host(const std::vector<std::string> & arguments, bool use_global_arguments)
{
  auto controller = std::make_shared<ControllerT>();
  auto options = controller->define_custom_node_options();
  options.arguments(arguments).use_global_arguments(use_global_arguments);
  controller->_start("controller", options);
  rosward::spun(controller->get_node()->get_node_base_interface());
  rosward::spin();
}
}  // namespace controller_interface
