// SPDX-License-Identifier: Apache-2.0
// rclcpp::exceptions: what does rclcpp throw?
//
// Read from rclcpp, branches humble, jazzy and rolling (exceptions/exceptions.hpp, parameter_value.hpp, context.hpp).

namespace rclcpp
{
namespace exceptions
{
class NameValidationError : public std::invalid_argument
{
public:
  NameValidationError(const std::string & message) : std::invalid_argument(message) {}
};
class InvalidNodeNameError : public NameValidationError
{
public:
  InvalidNodeNameError(const std::string & message) : NameValidationError(message) {}
};
class InvalidNamespaceError : public NameValidationError
{
public:
  InvalidNamespaceError(const std::string & message) : NameValidationError(message) {}
};
class InvalidTopicNameError : public NameValidationError
{
public:
  InvalidTopicNameError(const std::string & message) : NameValidationError(message) {}
};
class InvalidServiceNameError : public NameValidationError
{
public:
  InvalidServiceNameError(const std::string & message) : NameValidationError(message) {}
};
class RCLErrorBase
{
public:
  int ret;
  std::string message;
  std::string formatted_message;
};
class RCLError : public RCLErrorBase, public std::runtime_error
{
public:
  RCLError(const std::string & message) : std::runtime_error(message) {}
};
class RCLBadAlloc : public RCLErrorBase, public std::bad_alloc {};
class RCLInvalidArgument : public RCLErrorBase, public std::invalid_argument
{
public:
  RCLInvalidArgument(const std::string & message) : std::invalid_argument(message) {}
};
class RCLInvalidROSArgsError : public RCLErrorBase, public std::runtime_error
{
public:
  RCLInvalidROSArgsError(const std::string & message) : std::runtime_error(message) {}
};
class UnknownROSArgsError : public std::runtime_error
{
public:
  std::vector<std::string> unknown_ros_args;
  UnknownROSArgsError(const std::string & message) : std::runtime_error(message) {}
};
class UnimplementedError : public std::runtime_error
{
public:
  UnimplementedError(const std::string & message) : std::runtime_error(message) {}
};
class UnsupportedEventTypeException : public RCLErrorBase, public std::runtime_error
{
public:
  UnsupportedEventTypeException(const std::string & message) : std::runtime_error(message) {}
};
class InvalidEventError : public std::runtime_error
{
public:
  InvalidEventError() : std::runtime_error("event is invalid") {}
};
class InvalidParametersException : public std::runtime_error
{
public:
  InvalidParametersException(const std::string & message) : std::runtime_error(message) {}
};
class InvalidParameterValueException : public std::runtime_error
{
public:
  InvalidParameterValueException(const std::string & message) : std::runtime_error(message) {}
};
class InvalidParameterException : public InvalidParameterValueException
{
public:
  InvalidParameterException(const std::string & name) : InvalidParameterValueException(name) {}
};
class InvalidParameterTypeException : public std::runtime_error
{
public:
  InvalidParameterTypeException(const std::string & name, const std::string & message)
  : std::runtime_error("parameter '" + name + "' has invalid type: " + message) {}
};
class UninitializedStaticallyTypedParameterException : public InvalidParameterTypeException
{
public:
  UninitializedStaticallyTypedParameterException(const std::string & name)
  : InvalidParameterTypeException(name, "cannot declare a statically typed parameter with an uninitialized value") {}
};
class ParameterAlreadyDeclaredException : public std::runtime_error
{
public:
  ParameterAlreadyDeclaredException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' has already been declared") {}
};
class ParameterNotDeclaredException : public std::runtime_error
{
public:
  ParameterNotDeclaredException(const std::string & name) : std::runtime_error(name) {}
};
class ParameterImmutableException : public std::runtime_error
{
public:
  ParameterImmutableException(const std::string & message) : std::runtime_error(message) {}
};
class ParameterModifiedInCallbackException : public std::runtime_error
{
public:
  ParameterModifiedInCallbackException(const std::string & message) : std::runtime_error(message) {}
};
class ParameterUninitializedException : public std::runtime_error
{
public:
  ParameterUninitializedException(const std::string & name)
  : std::runtime_error("parameter '" + name + "' is not initialized") {}
};
class QoSCheckCompatibleException : public std::runtime_error
{
public:
  QoSCheckCompatibleException(const std::string & message) : std::runtime_error(message) {}
};
class NameNotRemappedError : public std::runtime_error
{
public:
  NameNotRemappedError(const std::string & message) : std::runtime_error(message) {}
};
}  // namespace exceptions

class ParameterTypeException : public std::runtime_error
{
public:
  ParameterTypeException(const std::string & message) : std::runtime_error(message) {}
};
class ContextAlreadyInitialized : public std::runtime_error
{
public:
  ContextAlreadyInitialized() : std::runtime_error("context is already initialized") {}
};
class NameSubNamespaceError : public std::invalid_argument
{
public:
  NameSubNamespaceError(const std::string & message) : std::invalid_argument(message) {}
};
}  // namespace rclcpp
