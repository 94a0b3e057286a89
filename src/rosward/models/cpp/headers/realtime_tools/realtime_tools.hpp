// SPDX-License-Identifier: Apache-2.0
// realtime_tools: publishers, buffers and servers that threads share.
//
// Read from ros-controls/realtime_tools, branches humble and master (realtime_publisher.hpp, realtime_buffer.hpp, realtime_box.hpp,
// realtime_server_goal_handle.hpp).

namespace realtime_tools
{
template<class MessageT>
class RealtimePublisher
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(RealtimePublisher)
  using MessageType = MessageT;
  MessageT msg_;
  RealtimePublisher() {}
  template<typename PublisherT>
  explicit RealtimePublisher(PublisherT publisher) : _publisher(publisher) {}
  void stop() {}
  bool trylock() {return rosward::unknown("live", "whether a lock is free", "bool");}
  void lock() {}
  void unlock() {}
  void unlockAndPublish() {_publisher->publish(msg_);}
  bool can_publish() const {return rosward::unknown("live", "whether a lock is free", "bool");}
  bool tryPublish(const MessageT & message) {return try_publish(message);}
  bool try_publish(const MessageT & message)
  {
    _publisher->publish(message);
    return rosward::unknown("live", "whether a lock is free", "bool");
  }

  rosward::value _publisher;
};

template<class T>
class RealtimeBuffer
{
public:
  RealtimeBuffer() {}
  explicit RealtimeBuffer(const T & data) : _data(data) {}
  T * readFromNonRT() const {return &_data;}
  T * readFromRT() {return &_data;}
  void writeFromNonRT(const T & data) {_data = data;}
  void initRT(const T & data) {_data = data;}
  void reset() {}

  T _data;
};

template<class T>
class RealtimeBox
{
public:
  RealtimeBox() {}
  explicit RealtimeBox(const T & initial) : _data(initial) {}
  void set(const T & value) {_data = value;}
  bool try_set(const T & value)
  {
    _data = value;
    return true;
  }
  T get() const {return _data;}
  void get(T & out) const {out = _data;}
  bool try_get(T & out) const
  {
    out = _data;
    return true;
  }

  T _data;
};
template<class T>
using RealtimeThreadSafeBox = RealtimeBox<T>;
template<class T>
using RealtimeBoxBestEffort = RealtimeBox<T>;

template<class ActionT>
class RealtimeServerGoalHandle
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(RealtimeServerGoalHandle)
  std::shared_ptr<rclcpp_action::ServerGoalHandle<ActionT>> gh_;
  std::shared_ptr<typename ActionT::Result> preallocated_result_;
  std::shared_ptr<typename ActionT::Feedback> preallocated_feedback_;

  template<typename... ArgsT>
  explicit RealtimeServerGoalHandle(std::shared_ptr<rclcpp_action::ServerGoalHandle<ActionT>> gh, const ArgsT & ... others)
  : gh_(gh), preallocated_result_(std::make_shared<typename ActionT::Result>()),
    preallocated_feedback_(std::make_shared<typename ActionT::Feedback>()) {}
  template<typename... ResultT>
  void setAborted(const ResultT & ... result) {(gh_->abort(result), ...);}
  template<typename... ResultT>
  void setCanceled(const ResultT & ... result) {(gh_->canceled(result), ...);}
  template<typename... ResultT>
  void setSucceeded(const ResultT & ... result) {(gh_->succeed(result), ...);}
  template<typename... FeedbackT>
  void setFeedback(const FeedbackT & ... feedback) {(gh_->publish_feedback(feedback), ...);}
  bool valid() {return true;}
  void execute() {}
  void runNonRealtime() {}
};
}  // namespace realtime_tools
