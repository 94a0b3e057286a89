// SPDX-License-Identifier: Apache-2.0
// tf2: what it throws, and what holds frames. Geometry decides nothing here.
//
// Read from ros2/geometry2, branches humble to rolling (tf2/include/tf2/exceptions.h, buffer_core.h).

namespace [[rosward::holds, rosward::pure]] tf2
{
class TransformException : public std::runtime_error
{
public:
  TransformException(const std::string & description = "") : std::runtime_error(description) {}
};
class ConnectivityException : public TransformException {};
class LookupException : public TransformException {};
class ExtrapolationException : public TransformException {};
class InvalidArgumentException : public TransformException {};
class TimeoutException : public TransformException {};
class NoDataForExtrapolationException : public LookupException {};
class TransformerException : public TransformException {};

class BufferCore
{
public:
  template<typename... ArgsT>
  explicit BufferCore(const ArgsT & ... args) {}
  virtual ~BufferCore() {}
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] geometry_msgs::msg::TransformStamped lookupTransform(const ArgsT & ... args) const
  {
    rosward::may_throw();
    return rosward::message<geometry_msgs::msg::TransformStamped>();
  }
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] bool canTransform(const ArgsT & ... args) const {return rosward::unknown("live", "whether a transform is there", "bool");}
  template<typename... ArgsT>
  bool setTransform(const ArgsT & ... args) {return true;}
  void setUsingDedicatedThread(bool value) {}
  void clear() {}
  [[rosward::source("tf")]] std::vector<std::string> getAllFrameNames() const {return rosward::unknown("live", "frames");}
};
}  // namespace tf2
