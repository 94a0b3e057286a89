// flow: topic:/first: data topic:/once; trigger timer
// flow: topic:/odd: data response:/odd topic:/in
// flow: request:/odd: data topic:/in
// flow: topic:/state: control response:/lamp/get_state; trigger timer
// flow: request:/lamp/get_state: trigger timer
// flow: topic:/speed: data topic:/odom; trigger timer
// flow: topic:/focus: data topic:/camera/camera_info topic:/camera/image; trigger timer
// flow: topic:/pose: data tf; trigger timer
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "image_transport/image_transport.hpp"
#include "nav2_util/lifecycle_service_client.hpp"
#include "nav2_util/odometry_utils.hpp"
#include "nav2_util/robot_utils.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/wait_for_message.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "std_msgs/msg/float64.hpp"
#include "tf2_ros/buffer.h"

using std_msgs::msg::Float64;

class Beside : public rclcpp::Node
{
public:
  Beside() : Node("beside"), buffer_(get_clock()), lamp_("/lamp", this)
  {
    first_ = create_publisher<Float64>("/first", 10);
    odd_ = create_publisher<Float64>("/odd", 10);
    state_ = create_publisher<Float64>("/state", 10);
    speed_ = create_publisher<Float64>("/speed", 10);
    focus_ = create_publisher<Float64>("/focus", 10);
    pose_ = create_publisher<Float64>("/pose", 10);
    client_ = create_generic_client("/odd", "std_srvs/srv/Trigger");
    odom_ = std::make_shared<nav2_util::OdomSmoother>(this, 0.3, "/odom");
    camera_ = image_transport::create_camera_subscription(
      this, "/camera/image",
      [this](const sensor_msgs::msg::Image::ConstSharedPtr & image, const sensor_msgs::msg::CameraInfo::ConstSharedPtr & info) {
        seen_.data = image->data[0] * info->k[0];
      }, "raw");
    sub_ = create_subscription<Float64>("/in", 10, [this](const Float64::SharedPtr in) {
      auto answer = client_->async_send_request(static_cast<void *>(in.get()));
      Float64 out;
      out.data = *static_cast<double *>(answer.get().get());
      odd_->publish(out);
    });
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
  }

private:
  void tick()
  {
    Float64 once, moving, where;
    rclcpp::wait_for_message(once, shared_from_this(), "/once");
    first_->publish(once);
    if (lamp_.get_state() == 3) {
      state_->publish(Float64());
    }
    moving.data = odom_->getTwist().linear.x;
    speed_->publish(moving);
    focus_->publish(seen_);
    geometry_msgs::msg::PoseStamped pose;
    nav2_util::getCurrentPose(pose, buffer_, "map", "base");
    where.data = pose.pose.position.x;
    pose_->publish(where);
  }

  Float64 seen_;
  tf2_ros::Buffer buffer_;
  nav2_util::LifecycleServiceClient lamp_;
  image_transport::CameraSubscriber camera_;
  std::shared_ptr<nav2_util::OdomSmoother> odom_;
  rclcpp::GenericClient::SharedPtr client_;
  rclcpp::Publisher<Float64>::SharedPtr first_, odd_, state_, speed_, focus_, pose_;
  rclcpp::Subscription<Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Beside>());
  return 0;
}
