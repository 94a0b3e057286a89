// What is written to a copy is not in the original.
// flow: topic:/out: trigger topic:/in
// flow: topic:/other: data topic:/in
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
    out_ = create_publisher<Float64>("out", 10);
    other_ = create_publisher<Float64>("other", 10);
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Publisher<Float64>::SharedPtr other_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;

  void on(const Float64::SharedPtr msg)
  {
    Float64 first;
    Float64 second = first;
    Float64 & third = second;
    third.data = msg->data;
    out_->publish(first);
    other_->publish(second);
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
