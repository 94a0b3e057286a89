// flow: request:/other/get_parameters: trigger topic:/in
// flow: request:/other/list_parameters: trigger topic:/in
// flow: request:/other/set_parameters: data topic:/in
// flow: request:/other/set_parameters: trigger topic:/in
// flow: topic:/limit: data response:/other/get_parameters; trigger timer topic:/in
// flow: topic:/known: control response:/other/list_parameters; trigger topic:/in
// flow: topic:/set: control response:/other/set_parameters; trigger topic:/in
// flow: topic:/changed: data topic:/parameter_events; trigger parameters timer
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

using std_msgs::msg::Float64;

class Asking : public rclcpp::Node
{
public:
  Asking() : Node("asking")
  {
    limit_ = create_publisher<Float64>("/limit", 10);
    known_ = create_publisher<Float64>("/known", 10);
    set_ = create_publisher<Float64>("/set", 10);
    changed_ = create_publisher<Float64>("/changed", 10);
    now_ = std::make_shared<rclcpp::SyncParametersClient>(this, "other");
    later_ = std::make_shared<rclcpp::AsyncParametersClient>(this, "other");
    events_ = std::make_shared<rclcpp::ParameterEventHandler>(this);
    handle_ = events_->add_parameter_callback("speed", [this](const rclcpp::Parameter & p) { last_.data = p.as_double(); }, "/other");
    sub_ = create_subscription<Float64>("/in", 10, [this](const Float64 & in) { on(in); });
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      limit_->publish(found_);
      changed_->publish(last_);
    });
  }

private:
  void on(const Float64 & in)
  {
    later_->set_parameters({rclcpp::Parameter("speed", in.data)});
    later_->get_parameters({"limit"}, [this](std::shared_future<std::vector<rclcpp::Parameter>> found) {
      found_.data = found.get().front().as_double();
    });
    if (now_->has_parameter("limit")) {
      known_->publish(Float64());
    }
    if (now_->set_parameters({rclcpp::Parameter("speed", 1.0)}).front().successful) {
      set_->publish(Float64());
    }
  }

  Float64 found_, last_;
  std::shared_ptr<rclcpp::SyncParametersClient> now_;
  std::shared_ptr<rclcpp::AsyncParametersClient> later_;
  std::shared_ptr<rclcpp::ParameterEventHandler> events_;
  std::shared_ptr<rclcpp::ParameterCallbackHandle> handle_;
  rclcpp::Publisher<Float64>::SharedPtr limit_, known_, set_, changed_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Asking>());
  return 0;
}
