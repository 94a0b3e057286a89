// SPDX-License-Identifier: Apache-2.0
// rclcpp: types of a program that stand for a message. What goes over the wire is the message.
//
// Read from rclcpp, branches humble, jazzy and rolling (type_adapter.hpp, serialized_message.hpp, loaned_message.hpp, message_info.hpp).

namespace rclcpp
{
template<typename CustomType, typename ROSMessageType = void, class Enable = void>
struct TypeAdapter
{
  using custom_type = CustomType;
  using ros_message_type = ROSMessageType;
};

template<typename T>
struct ImplicitTypeAdapter
{
  using custom_type = T;
  using ros_message_type = T;
};

template<typename CustomType>
struct adapt_type
{
  template<typename ROSMessageType>
  using as = TypeAdapter<CustomType, ROSMessageType>;
};

namespace detail
{
template<typename T>
struct Adapted
{
  using custom_type = typename ImplicitTypeAdapter<T>::custom_type;
  using ros_message_type = typename ImplicitTypeAdapter<T>::ros_message_type;
};
template<typename CustomType, typename ROSMessageType>
struct Adapted<TypeAdapter<CustomType, ROSMessageType>>
{
  using custom_type = CustomType;
  using ros_message_type = ROSMessageType;
};

// The same as types: those of what is adapted, else the message itself.
template<typename MessageT, bool adapted = rosward::is_adapted<MessageT>()>
struct Types
{
  using custom_type = MessageT;
  using ros_message_type = MessageT;
};
template<typename MessageT>
struct Types<MessageT, true> : Adapted<MessageT> {};
template<typename MessageT>
using custom_t = typename Types<MessageT>::custom_type;
template<typename MessageT>
using wire_t = typename Types<MessageT>::ros_message_type;

// What goes over the wire, and what callbacks get.
template<typename MessageT>
auto wire_type()
{
  if (rosward::is_adapted<MessageT>()) {
    return rosward::type<typename Adapted<MessageT>::ros_message_type>();
  }
  return rosward::type<MessageT>();
}
template<typename MessageT>
auto custom_type()
{
  if (rosward::is_adapted<MessageT>()) {
    return rosward::type<typename Adapted<MessageT>::custom_type>();
  }
  return rosward::type<MessageT>();
}
}  // namespace detail

class SerializedMessage
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SerializedMessage)
  SerializedMessage() {}
  explicit SerializedMessage(size_t initial_capacity) {}
  size_t size() const;
  size_t capacity() const;
  void reserve(size_t capacity) {}
  auto & get_rcl_serialized_message() {return *this;}
  size_t buffer_length;
  uint8_t * buffer;
};

class SerializationBase
{
public:
  template<typename MessageT>
  [[rosward::changes("serialized_message")]] void serialize_message(const MessageT & ros_message, SerializedMessage * serialized_message) const {}
  template<typename MessageT>
  [[rosward::changes("ros_message")]] void deserialize_message(const SerializedMessage * serialized_message, MessageT * ros_message) const
  {
    rosward::fill(ros_message);
  }
};

template<typename MessageT>
class Serialization : public SerializationBase {};

template<typename MessageT, typename AllocatorT = std::allocator<void>>
class LoanedMessage
{
public:
  LoanedMessage() : _message(std::make_shared<MessageT>()) {}
  bool is_valid() const {return true;}
  MessageT & get() const {return *_message;}

  std::shared_ptr<MessageT> _message;
};

class MessageInfo
{
public:
  MessageInfo() {}
  const rmw_message_info_t & get_rmw_message_info() const;
};
}  // namespace rclcpp
