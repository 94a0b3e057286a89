// A parameter that is declared, and one that is asked for with an out-argument.
// flow: topic:/out: data parameter:rate; trigger timer
// flow: topic:/other: data parameter:name; trigger timer
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
    other_ = create_publisher<String>("other", 10);
    rate_ = declare_parameter<double>("rate", 1.0);
    declare_parameter("name", "robot");
    get_parameter("name", name_);
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Publisher<String>::SharedPtr other_;
  rclcpp::TimerBase::SharedPtr timer_;
  double rate_;
  std::string name_;

  void tick()
  {
    Float64 made;
    made.data = rate_;
    out_->publish(made);
    String text;
    text.data = name_;
    other_->publish(text);
  }

};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
