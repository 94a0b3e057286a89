// Nobody holds a timer any more: the message decides whether the callback runs on.
// flow: topic:/out: trigger timer
// flow: topic:/out: control topic:/in; trigger timer
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"
using std_msgs::msg::Float64;
class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    out_ = create_publisher<Float64>("out", 10);
    sub_ = create_subscription<Float64>("in", 10, std::bind(&App::on, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&App::tick, this));
    other_ = create_wall_timer(std::chrono::seconds(1), [this]() {Float64 m; m.data = 2.0; out_->publish(m);});
  }
private:
  void on(const Float64::SharedPtr msg) { if (msg->data > 0.0) { timer_.reset(); } }
  void tick() { Float64 m; m.data = 1.0; out_->publish(m); }
  rclcpp::TimerBase::SharedPtr timer_, other_;
  rclcpp::Publisher<Float64>::SharedPtr out_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<App>()); }
