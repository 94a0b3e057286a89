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
class ConnectivityException : public TransformException
{
public:
  using TransformException::TransformException;
};
class LookupException : public TransformException
{
public:
  using TransformException::TransformException;
};
class ExtrapolationException : public TransformException
{
public:
  using TransformException::TransformException;
};
class InvalidArgumentException : public TransformException
{
public:
  using TransformException::TransformException;
};
class TimeoutException : public TransformException
{
public:
  using TransformException::TransformException;
};
class NoDataForExtrapolationException : public LookupException {};
class TransformerException : public TransformException {};

namespace detail
{
// What is asked for may not be there: which exception says so, depends on what came.
inline void may_be_missing()
{
  const std::string why = rosward::unknown("live", "why a transform is not there", "std::string");
  rosward::may_throw(
    LookupException(why), ConnectivityException(why), ExtrapolationException(why), InvalidArgumentException(why), TimeoutException(why),
    TransformException(why));
}
}  // namespace detail

class BufferCore
{
public:
  template<typename... ArgsT>
  explicit BufferCore(const ArgsT & ... args) {}
  virtual ~BufferCore() {}
  template<typename... ArgsT>
  [[rosward::holds, rosward::source("tf")]] geometry_msgs::msg::TransformStamped lookupTransform(const ArgsT & ... args) const
  {
    detail::may_be_missing();
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
