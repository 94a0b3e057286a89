// Members of one initialiser list do not hold what is given for others.
// flow: topic:/gain: data parameter:gain; trigger timer
// flow: topic:/rows: data parameter:rows; trigger timer
// flow: topic:/length: data parameter:name; trigger timer
// flow: topic:/zero: trigger timer
// flow: topic:/inner: data parameter:rows; trigger timer
// flow: topic:/pose: data topic:/x; trigger timer
#include <chrono>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::Float64;
using std_msgs::msg::String;

struct Filter
{
  Filter(double gain, const std::string & name, std::vector<double> rows)
  : gain_(gain), name_(name), rows_(rows), twice_(gain * 2.0) {}
  double gain_;
  std::string name_;
  std::vector<double> rows_;
  double twice_;
};

class App : public rclcpp::Node
{
public:
  App()
  : Node("app"), gain_(declare_parameter("gain", 1.0)), name_(declare_parameter("name", "a")),
    rows_(declare_parameter("rows", std::vector<double>{1.0})), filter_(gain_, name_, rows_),
    odometry_(vendor::initial), zero_(0.0)
  {
    gain_out_ = create_publisher<Float64>("gain", 10);
    rows_out_ = create_publisher<Float64>("rows", 10);
    length_out_ = create_publisher<Float64>("length", 10);
    zero_out_ = create_publisher<Float64>("zero", 10);
    inner_out_ = create_publisher<Float64>("inner", 10);
    pose_out_ = create_publisher<nav_msgs::msg::Odometry>("pose", 10);
    sub_ = create_subscription<Float64>("x", 10, std::bind(&App::on, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));
  }

private:
  void on(const Float64::SharedPtr msg) {odometry_.pose.pose.position.x = msg->data;}
  void tick()
  {
    Float64 gain, rows, length, zero, inner;
    gain.data = filter_.gain_;
    gain_out_->publish(gain);
    rows.data = rows_[0];
    rows_out_->publish(rows);
    length.data = name_.size();
    length_out_->publish(length);
    zero.data = zero_;
    zero_out_->publish(zero);
    inner.data = filter_.rows_[0];
    inner_out_->publish(inner);
    pose_out_->publish(odometry_);
  }

  double gain_;
  std::string name_;
  std::vector<double> rows_;
  Filter filter_;
  nav_msgs::msg::Odometry odometry_;
  double zero_;
  rclcpp::Publisher<Float64>::SharedPtr gain_out_, rows_out_, length_out_, zero_out_, inner_out_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr pose_out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
