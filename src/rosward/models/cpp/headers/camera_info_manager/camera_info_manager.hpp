// SPDX-License-Identifier: Apache-2.0
// camera_info_manager: a camera driver that keeps its calibration serves what sets it.
//
// Read from ros-perception/image_common, branches humble, iron, jazzy and rolling (camera_info_manager.hpp,
// src/camera_info_manager.cpp). In humble the service is below the namespace of the node, since iron below its name.

namespace camera_info_manager
{
class CameraInfoManager
{
public:
  [[rosward::creator]] CameraInfoManager(
    rclcpp::Node * node, const std::string & cname = "camera", const std::string & url = "", const std::string & ns = "~")
  {
    _serve(node, ns, 10);
  }
  [[rosward::creator]] CameraInfoManager(
    rclcpp_lifecycle::LifecycleNode * node, const std::string & cname = "camera", const std::string & url = "",
    const std::string & ns = "~")
  {
    _serve(node, ns, 10);
  }
  [[rosward::creator]] CameraInfoManager(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base_interface,
    rclcpp::node_interfaces::NodeServicesInterface::SharedPtr node_services_interface,
    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logger_interface,
    const std::string & cname = "camera", const std::string & url = "",
    rmw_qos_profile_t custom_qos = rmw_qos_profile_default, const std::string & ns = "~")
  {
    _serve(node_services_interface, ns, custom_qos);
  }

  sensor_msgs::msg::CameraInfo getCameraInfo() {return rosward::unknown("file", "calibration of a camera");}
  bool isCalibrated() {return rosward::unknown("file", "calibration of a camera", "bool");}
  bool loadCameraInfo(const std::string & url) {return rosward::unknown("file", "calibration of a camera", "bool");}
  std::string resolveURL(const std::string & url, const std::string & cname)
  {
    return rosward::unknown("environment", "place of a calibration", "str");
  }
  bool setCameraName(const std::string & cname) {return rosward::unknown("file", "calibration of a camera", "bool");}
  bool setCameraInfo(const sensor_msgs::msg::CameraInfo & camera_info)
  {
    return rosward::unknown("file", "calibration of a camera", "bool");
  }
  bool validateURL(const std::string & url) {return rosward::unknown("file", "calibration of a camera", "bool");}

  template<typename NodeT, typename QosT>
  void _serve(NodeT node, const std::string & ns, const QosT & qos)
  {
#if RCLCPP_VERSION_GTE(21, 0, 0)
    const std::string name = ns + "/set_camera_info";
#else
    const std::string name = "set_camera_info";
#endif
    rosward::create(
      "service_server", rosward::interface_of(node), name, rosward::type<sensor_msgs::srv::SetCameraInfo>(), qos);
  }
};
}  // namespace camera_info_manager
