// The terminal, a file, another program.
// flow: stdout: data topic:/in
// flow: file: data topic:/in
// flow: process: data topic:/name
#include <chrono>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using std_msgs::msg::Float64;
using std_msgs::msg::String;
using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::Twist;
using SetBool = std_srvs::srv::SetBool;

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    file_.open("/tmp/values.txt");
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
    name_ = create_subscription<String>("name", 10, std::bind(&App::on_name, this, std::placeholders::_1));

  }

private:
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::Subscription<String>::SharedPtr name_;
  std::ofstream file_;

  void on(const Float64::SharedPtr msg)
  {
    std::cout << "got " << msg->data << std::endl;
    file_ << msg->data << "\n";
  }
  void on_name(const String::SharedPtr msg)
  {
    std::string command = "play " + msg->data;
    system(command.c_str());
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
