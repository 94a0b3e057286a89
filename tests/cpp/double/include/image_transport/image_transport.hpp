// SPDX-License-Identifier: Apache-2.0
// Images: the transport `raw`, which needs no plugin.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport
{
using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;

class TransportHints
{
public:
  template<typename N>
  explicit TransportHints(N && node, const std::string & transport = "raw", const std::string & = "image_transport") : transport_(transport)
  {
    (void)node;
  }
  const std::string & getTransport() const { return transport_; }

private:
  std::string transport_;
};

class Publisher
{
public:
  Publisher() = default;
  explicit Publisher(rclcpp::Publisher<Image>::SharedPtr publisher) : publisher_(std::move(publisher)) {}
  void publish(const Image &) const {}
  void publish(const Image::ConstSharedPtr &) const {}
  std::string getTopic() const { return publisher_->get_topic_name(); }
  size_t getNumSubscribers() const { return 1; }
  void shutdown() { publisher_.reset(); }

private:
  rclcpp::Publisher<Image>::SharedPtr publisher_;
};

class Subscriber
{
public:
  Subscriber() = default;
  explicit Subscriber(rclcpp::Subscription<Image>::SharedPtr subscription) : subscription_(std::move(subscription)) {}
  std::string getTopic() const { return subscription_->get_topic_name(); }
  void shutdown() { subscription_.reset(); }

private:
  rclcpp::Subscription<Image>::SharedPtr subscription_;
};

inline std::string getCameraInfoTopic(const std::string & base) { return base.substr(0, base.rfind('/') + 1) + "camera_info"; }

class CameraPublisher
{
public:
  CameraPublisher() = default;
  CameraPublisher(rosward_double::Core & node, const std::string & base)
  : image_(rosward_double::publisher<Image>(node, base)),
    info_(rosward_double::publisher<CameraInfo>(node, getCameraInfoTopic(node.resolve(base, false))))
  {
  }
  void publish(const Image &, const CameraInfo &) const {}
  void publish(const Image::ConstSharedPtr &, const CameraInfo::ConstSharedPtr &) const {}
  size_t getNumSubscribers() const { return 1; }

private:
  rclcpp::Publisher<Image>::SharedPtr image_;
  rclcpp::Publisher<CameraInfo>::SharedPtr info_;
};

class CameraSubscriber
{
public:
  using Callback = std::function<void(const Image::ConstSharedPtr &, const CameraInfo::ConstSharedPtr &)>;
  CameraSubscriber() = default;
  CameraSubscriber(rosward_double::Core & node, const std::string & base, Callback callback)
  : image_(rosward_double::subscription<Image>(node, base,
      [callback](std::shared_ptr<const Image> image) { callback(image, std::make_shared<CameraInfo>()); })),
    info_(rosward_double::subscription<CameraInfo>(
        node, getCameraInfoTopic(node.resolve(base, false)), [](std::shared_ptr<const CameraInfo>) {}))
  {
  }

private:
  rclcpp::Subscription<Image>::SharedPtr image_;
  rclcpp::Subscription<CameraInfo>::SharedPtr info_;
};

template<typename N, typename Q = rclcpp::QoS>
Publisher create_publisher(N && node, const std::string & base, const Q & = rclcpp::QoS(10), const rclcpp::PublisherOptions & = {})
{
  return Publisher(rosward_double::publisher<Image>(*rosward_double::core_of(node), base));
}
template<typename N, typename F, typename Q = rclcpp::QoS>
Subscriber create_subscription(
  N && node, const std::string & base, F callback, const std::string &, const Q & = rclcpp::QoS(10), const rclcpp::SubscriptionOptions & = {})
{
  return Subscriber(rosward_double::subscription<Image>(*rosward_double::core_of(node), base, std::move(callback)));
}
template<typename N, typename Q = rclcpp::QoS>
CameraPublisher create_camera_publisher(N && node, const std::string & base, const Q & = rclcpp::QoS(10), const rclcpp::PublisherOptions & = {})
{
  return CameraPublisher(*rosward_double::core_of(node), base);
}
template<typename N, typename F, typename Q = rclcpp::QoS>
CameraSubscriber create_camera_subscription(N && node, const std::string & base, F callback, const std::string &, const Q & = rclcpp::QoS(10))
{
  return CameraSubscriber(*rosward_double::core_of(node), base, std::move(callback));
}

class ImageTransport
{
public:
  template<typename N>
  explicit ImageTransport(N && node) : node_(rosward_double::core_of(node))
  {
  }
  Publisher advertise(const std::string & base, uint32_t, bool = false) { return Publisher(rosward_double::publisher<Image>(*node_, base)); }
  CameraPublisher advertiseCamera(const std::string & base, uint32_t, bool = false) { return CameraPublisher(*node_, base); }
  template<typename F, typename ... T>
  Subscriber subscribe(const std::string & base, uint32_t, F callback, const T & ...)
  {
    return Subscriber(rosward_double::subscription<Image>(*node_, base, std::move(callback)));
  }
  CameraSubscriber subscribeCamera(const std::string & base, uint32_t, CameraSubscriber::Callback callback, const TransportHints * = nullptr)
  {
    return CameraSubscriber(*node_, base, std::move(callback));
  }
  template<typename C>
  CameraSubscriber subscribeCamera(
    const std::string & base, uint32_t, void (C::* method)(const Image::ConstSharedPtr &, const CameraInfo::ConstSharedPtr &), C * object,
    const TransportHints * = nullptr)
  {
    return CameraSubscriber(*node_, base, [method, object](const auto & image, const auto & info) { (object->*method)(image, info); });
  }
  template<typename C, typename P>
  Subscriber subscribe(const std::string & base, uint32_t depth, void (C::* method)(P), C * object, const TransportHints * = nullptr)
  {
    return subscribe(base, depth, [method, object](const std::shared_ptr<const Image> & image) { (object->*method)(image); });
  }

private:
  std::shared_ptr<rosward_double::Core> node_;
};
}  // namespace image_transport
