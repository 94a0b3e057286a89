// A macro of rcutils gets no logger: what stands first may be the condition.
// flow: log: data parameter:loud parameter:level; trigger main
#include "rclcpp/rclcpp.hpp"

class App : public rclcpp::Node
{
public:
  App() : Node("app"), loud_(declare_parameter("loud", true)), level_(declare_parameter("level", 1))
  {
    RCUTILS_LOG_INFO_EXPRESSION_NAMED(loud_, "app", "level %d", level_);
  }

private:
  bool loud_;
  int level_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<App>());
  rclcpp::shutdown();
  return 0;
}
