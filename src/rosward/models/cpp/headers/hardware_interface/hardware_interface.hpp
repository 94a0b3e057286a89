// SPDX-License-Identifier: Apache-2.0
// hardware_interface: drivers of hardware, which have no node of their own.
//
// Read from ros-controls/ros2_control, branches humble to master (hardware_interface/include/hardware_interface/*).

namespace hardware_interface
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
enum class return_type { OK = 0, ERROR = 1, DEACTIVATE = 2 };
constexpr char HW_IF_POSITION[] = "position";
constexpr char HW_IF_VELOCITY[] = "velocity";
constexpr char HW_IF_ACCELERATION[] = "acceleration";
constexpr char HW_IF_EFFORT[] = "effort";

struct InterfaceInfo
{
  std::string name;
  std::string min;
  std::string max;
  std::string initial_value;
  std::string data_type;
  int size;
};
struct ComponentInfo
{
  std::string name;
  std::string type;
  std::vector<InterfaceInfo> command_interfaces;
  std::vector<InterfaceInfo> state_interfaces;
  std::unordered_map<std::string, std::string> parameters;
};
struct HardwareInfo
{
  std::string name;
  std::string type;
  std::string hardware_plugin_name;
  std::unordered_map<std::string, std::string> hardware_parameters;
  std::vector<ComponentInfo> joints;
  std::vector<ComponentInfo> sensors;
  std::vector<ComponentInfo> gpios;
};

class Handle
{
public:
  template<typename... ArgsT>
  Handle(const ArgsT & ... args) {}
  std::string get_name() const;
  std::string get_full_name() const;
  std::string get_interface_name() const;
  std::string get_prefix_name() const;
  double get_value() const;
  template<typename T = double>
  auto get_optional() const {return rosward::unknown("live", "state of the hardware");}
  template<typename T>
  bool set_value(const T & value) {return true;}
};
using StateInterface = Handle;
using CommandInterface = Handle;
using LoanedCommandInterface = Handle;
using LoanedStateInterface = Handle;

class HardwareComponentInterface : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface
{
public:
  virtual ~HardwareComponentInterface() {}
  virtual CallbackReturn on_init(const HardwareInfo & hardware_info)
  {
    info_ = hardware_info;
    return CallbackReturn::SUCCESS;
  }

  HardwareInfo info_;
};
class SystemInterface : public HardwareComponentInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SystemInterface)
};
class ActuatorInterface : public HardwareComponentInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ActuatorInterface)
};
class SensorInterface : public HardwareComponentInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SensorInterface)
};
}  // namespace hardware_interface
