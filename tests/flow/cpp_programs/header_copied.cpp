// The header of a message goes on in another one.
// flow: topic:/out: data topic:/in
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
    out_ = create_publisher<PoseStamped>("out", 10);
    sub_ = create_subscription<PoseStamped>("in", 10, std::bind(&App::on, this, std::placeholders::_1));

  }

private:
  rclcpp::Publisher<PoseStamped>::SharedPtr out_;
  rclcpp::Subscription<PoseStamped>::SharedPtr sub_;

  void on(const PoseStamped::SharedPtr msg)
  {
    PoseStamped made;
    made.header = msg->header;
    made.pose.position.x = 1.0;
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
