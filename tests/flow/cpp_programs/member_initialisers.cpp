// What a constructor is given, and what refers to something else.
// flow: topic:/out: data topic:/in
// flow: topic:/other: data parameter:gain; trigger topic:/in
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

class Sink
{
public:
  Sink(double & target, double gain) : target_(target), gain_(gain) {}
  void take(double x) { target_ = x; }
  double gain() const { return gain_; }

private:
  double & target_;
  double gain_;
};

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
  double gain_ = declare_parameter<double>("gain", 2.0);

  void on(const Float64::SharedPtr msg)
  {
    double value = 0.0;
    Sink sink(value, gain_);
    sink.take(msg->data);
    Float64 made;
    made.data = value;
    out_->publish(made);
    Float64 second;
    second.data = sink.gain();
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
