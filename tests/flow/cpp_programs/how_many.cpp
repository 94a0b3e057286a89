// How many have arrived is no content of them.
// flow: topic:/out: trigger timer topic:/in
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
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));
  }

private:
  void on(const Float64::SharedPtr msg)
  {
    values_.push_back(msg->data);
    if (values_.size() > 10) {
      values_.pop_back();
    }
  }
  void tick()
  {
    if (values_.size() < 3) {
      return;
    }
    Float64 out;
    out.data = 1.0;
    out_->publish(out);
  }
  std::vector<double> values_;
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  return 0;
}
