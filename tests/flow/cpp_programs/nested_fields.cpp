// Only one of the fields of a message goes on.
// flow: topic:/out: data topic:/pose
// flow: topic:/other: trigger topic:/pose
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
    sub_ = create_subscription<PoseStamped>("pose", 10, std::bind(&App::on, this, std::placeholders::_1));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Publisher<Float64>::SharedPtr other_;
  rclcpp::Subscription<PoseStamped>::SharedPtr sub_;

  void on(const PoseStamped::SharedPtr msg)
  {
    Twist twist;
    twist.linear.x = msg->pose.position.x;
    twist.angular.z = 0.5;
    Float64 made;
    made.data = twist.linear.x;
    out_->publish(made);
    Float64 second;
    second.data = twist.angular.z;
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
