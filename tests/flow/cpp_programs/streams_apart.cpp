// A file that is written to is open or not, whatever is written; which pointers are let go does not depend on what they led to.
// flow: file: data topic:/speed; control file
// flow: file: data topic:/tone; control file
// flow: topic:/out: data topic:/text; control file
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

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    out_ = create_publisher<String>("out", 10);
    motor_ = std::make_shared<std::ofstream>("/dev/motor");
    if (!motor_->is_open()) {
      return;
    }
    buzzer_ = std::make_shared<std::ofstream>("/dev/buzzer");
    speed_ = create_subscription<Float64>("speed", 10, std::bind(&App::on_speed, this, std::placeholders::_1));
    tone_ = create_subscription<Float64>("tone", 10, std::bind(&App::on_tone, this, std::placeholders::_1));
    text_ = create_subscription<String>("text", 10, std::bind(&App::on_text, this, std::placeholders::_1));
  }
  ~App()
  {
    motor_.reset();
    buzzer_.reset();
    text_.reset();
  }

private:
  void on_speed(const Float64::SharedPtr msg) {*motor_ << msg->data << std::endl;}
  void on_tone(const Float64::SharedPtr msg) {*buzzer_ << msg->data << std::endl;}
  void on_text(const String::SharedPtr msg)
  {
    std::istringstream stream(msg->data);
    String made;
    std::getline(stream, made.data, '.');
    out_->publish(made);
  }

  std::shared_ptr<std::ofstream> motor_, buzzer_;
  rclcpp::Publisher<String>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr speed_, tone_;
  rclcpp::Subscription<String>::SharedPtr text_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
