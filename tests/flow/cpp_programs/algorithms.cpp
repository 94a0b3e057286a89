// Algorithms of the standard library.
// flow: topic:/out: data topic:/in
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
  std::vector<double> values_;

  void on(const Float64::SharedPtr msg)
  {
    values_.push_back(msg->data);
    Float64 made;
    made.data = *std::max_element(values_.begin(), values_.end());
    out_->publish(made);
    double sum = 0.0;
    std::for_each(values_.begin(), values_.end(), [&sum](double x) { sum += x; });
    Float64 second;
    second.data = sum;
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
