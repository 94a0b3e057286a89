// The clock, and numbers at random.
// flow: topic:/out: data random; trigger timer
// flow: topic:/stamped: data clock; trigger timer
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
    stamped_ = create_publisher<PoseStamped>("stamped", 10);
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Publisher<PoseStamped>::SharedPtr stamped_;
  rclcpp::TimerBase::SharedPtr timer_;

  void tick()
  {
    Float64 made;
    made.data = rand() % 10;
    out_->publish(made);
    PoseStamped pose;
    pose.header.stamp = now();
    stamped_->publish(pose);
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
