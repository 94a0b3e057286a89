// An object of its own keeps what it is given.
// flow: topic:/out: data topic:/in; trigger timer
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

class Filter
{
public:
  explicit Filter(double gain) : gain_(gain) {}
  void add(double x) { value_ = value_ + gain_ * (x - value_); }
  double value() const { return value_; }

private:
  double gain_;
  double value_ = 0.0;
};

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    out_ = create_publisher<Float64>("out", 10);
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
  Filter filter_{0.5};

  void on(const Float64::SharedPtr msg) { filter_.add(msg->data); }
  void tick()
  {
    Float64 made;
    made.data = filter_.value();
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
