// A service sets what a timer publishes.
// flow: response:/switch: trigger service:/switch
// flow: topic:/out: control service:/switch; trigger timer
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
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));
    service_ = create_service<SetBool>("switch", std::bind(&App::set, this, std::placeholders::_1, std::placeholders::_2));

  }

private:
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Service<SetBool>::SharedPtr service_;
  bool on_ = false;

  void set(const std::shared_ptr<SetBool::Request> request, std::shared_ptr<SetBool::Response> response)
  {
    on_ = request->data;
    response->success = true;
  }
  void tick()
  {
    if (!on_) {
      return;
    }
    Float64 made;
    made.data = 1.0;
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
