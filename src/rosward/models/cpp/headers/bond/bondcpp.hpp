// SPDX-License-Identifier: Apache-2.0
// bondcpp: both ends of a bond publish and subscribe.
//
// Read from ros/bond_core, branch ros2 (bondcpp/include/bondcpp/bond.hpp, src/bond.cpp).

namespace bond
{
namespace msg
{
// The constants of bond/msg/Constants.msg.
struct Constants
{
  static constexpr double DEAD_PUBLISH_PERIOD = 0.05;
  static constexpr double DEFAULT_CONNECT_TIMEOUT = 10.0;
  static constexpr double DEFAULT_HEARTBEAT_TIMEOUT = 4.0;
  static constexpr double DEFAULT_DISCONNECT_TIMEOUT = 2.0;
  static constexpr double DEFAULT_HEARTBEAT_PERIOD = 1.0;
  static constexpr char DISABLE_HEARTBEAT_TIMEOUT_PARAM[] = "/bond_disable_heartbeat_timeout";
};
}  // namespace msg

class Bond
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Bond)
  template<typename NodeT, typename BrokenT = int, typename FormedT = int>
  [[rosward::creator]] Bond(
    const std::string & topic, const std::string & id, NodeT node, const BrokenT & on_broken = nullptr,
    const FormedT & on_formed = nullptr)
  {
    auto found = rosward::interface_of(node);
    rosward::create("publisher", found, topic, rosward::type<bond::msg::Status>(), 5);
    rosward::create("subscription", found, topic, rosward::type<bond::msg::Status>(), 100);
    rosward::schedule(on_broken, "bond");
    rosward::schedule(on_formed, "bond");
  }
  void start() {}
  template<typename CallbackT>
  void setFormedCallback(CallbackT on_formed) {rosward::schedule(on_formed, "bond");}
  template<typename CallbackT>
  void setBrokenCallback(CallbackT on_broken) {rosward::schedule(on_broken, "bond");}
  template<typename... ArgsT>
  bool waitUntilFormed(const ArgsT & ... timeout) {return true;}
  template<typename... ArgsT>
  bool waitUntilBroken(const ArgsT & ... timeout) {return true;}
  void breakBond() {}
  bool isBroken();
  std::string getTopic() const;
  std::string getId() const;
  template<typename T>
  void setHeartbeatTimeout(const T & duration) {}
  template<typename T>
  void setHeartbeatPeriod(const T & duration) {}
  template<typename T>
  void setConnectTimeout(const T & duration) {}
  template<typename T>
  void setDisconnectTimeout(const T & duration) {}
};
}  // namespace bond
