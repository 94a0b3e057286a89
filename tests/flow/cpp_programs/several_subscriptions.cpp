// What a callback is bound to is not in the message that it gets, nor is the name of the topic.
// flow: topic:/out: data topic:/a/in topic:/b/in; control parameter:key parameter:names parameter:order.a parameter:order.b
// flow: topic:/bound: data topic:/c/in
// flow: topic:/key: data parameter:key; trigger topic:/c/in
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

struct Source
{
  int order = 0;
  rclcpp::Subscription<Float64>::SharedPtr sub;
};

class App : public rclcpp::Node
{
public:
  App() : Node("app")
  {
    out_ = create_publisher<Float64>("out", 10);
    bound_ = create_publisher<Float64>("bound", 10);
    key_ = create_publisher<Float64>("key", 10);
    const std::string key = declare_parameter("key", "c");
    sub_ = create_subscription<Float64>(key + "/in", 10, std::bind(&App::pass, this, std::placeholders::_1, key));
    const auto names = declare_parameter("names", std::vector<std::string>{"a", "b"});
    for (const auto & name : names) {
      sources_[name] = std::make_shared<Source>();
      sources_[name]->order = declare_parameter("order." + name, 1);
    }
    for (auto & entry : sources_) {
      const std::string & name = entry.first;
      entry.second->sub = create_subscription<Float64>(
        name + "/in", 10, [this, name](const Float64::SharedPtr msg) {choose(msg, name);});
    }
  }

private:
  void choose(const std::shared_ptr<Float64> msg, const std::string & key)
  {
    if (sources_.count(key) == 0) {
      return;
    }
    if (sources_[key]->order > last_) {
      last_ = sources_[key]->order;
      out_->publish(*msg);
    }
  }
  void pass(const std::shared_ptr<Float64> msg, const std::string & key)
  {
    bound_->publish(*msg);
    Float64 made;
    made.data = key.size();
    key_->publish(made);
  }

  int last_ = 0;
  std::map<std::string, std::shared_ptr<Source>> sources_;
  rclcpp::Publisher<Float64>::SharedPtr out_, bound_, key_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
