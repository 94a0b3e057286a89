// Two members of one object are two.
// flow: topic:/a: data topic:/in_a
// flow: topic:/b: data topic:/in_b
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

struct State
{
  Float64 first;
  Float64 second;
};

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    a_ = create_publisher<Float64>("a", 10);
    b_ = create_publisher<Float64>("b", 10);
    sub_a_ = create_subscription<Float64>("in_a", 10, std::bind(&App::on_a, this, std::placeholders::_1));
    sub_b_ = create_subscription<Float64>("in_b", 10, std::bind(&App::on_b, this, std::placeholders::_1));

  }

private:
  rclcpp::Subscription<Float64>::SharedPtr sub_a_;
  rclcpp::Subscription<Float64>::SharedPtr sub_b_;
  rclcpp::Publisher<Float64>::SharedPtr a_, b_;
  State state_;

  void on_a(const Float64::SharedPtr msg)
  {
    state_.first.data = msg->data;
    a_->publish(state_.first);
  }
  void on_b(const Float64::SharedPtr msg)
  {
    state_.second.data = msg->data;
    b_->publish(state_.second);
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
