// Elements of a vector under constant indices.
// flow: topic:/out: data topic:/a; trigger timer
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
    sub_a_ = create_subscription<Float64>("a", 10, std::bind(&App::on_a, this, std::placeholders::_1));
    sub_b_ = create_subscription<Float64>("b", 10, std::bind(&App::on_b, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_a_;
  rclcpp::Subscription<Float64>::SharedPtr sub_b_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::vector<double> values_{0.0, 0.0};

  void on_a(const Float64::SharedPtr msg) { values_[0] = msg->data; }
  void on_b(const Float64::SharedPtr msg) { values_[1] = msg->data; }
  void tick()
  {
    Float64 made;
    made.data = values_[0];
    out_->publish(made);
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
