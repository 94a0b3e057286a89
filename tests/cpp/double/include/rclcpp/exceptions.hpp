// SPDX-License-Identifier: Apache-2.0
// What rclcpp throws.
#pragma once

#include <stdexcept>
#include <string>

namespace rclcpp
{
class ParameterTypeException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

namespace exceptions
{
#define ROSWARD_DOUBLE_EXCEPTION(NAME, BASE) \
  class NAME : public BASE \
  { \
  public: \
    explicit NAME(const std::string & text) : BASE(text) {} \
  };

class RCLErrorBase
{
public:
  virtual ~RCLErrorBase() = default;
  int ret = 1;
  std::string message, file, formatted_message;
};

class RCLError : public RCLErrorBase, public std::runtime_error
{
public:
  explicit RCLError(const std::string & text) : std::runtime_error(text) {}
};

ROSWARD_DOUBLE_EXCEPTION(NameValidationError, std::invalid_argument)
ROSWARD_DOUBLE_EXCEPTION(InvalidNodeNameError, NameValidationError)
ROSWARD_DOUBLE_EXCEPTION(InvalidNamespaceError, NameValidationError)
ROSWARD_DOUBLE_EXCEPTION(InvalidTopicNameError, NameValidationError)
ROSWARD_DOUBLE_EXCEPTION(InvalidServiceNameError, NameValidationError)
ROSWARD_DOUBLE_EXCEPTION(UnknownROSArgsError, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(InvalidEventError, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(EventNotRegisteredError, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(UnsupportedEventTypeException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(InvalidParametersException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(InvalidParameterValueException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(ParameterAlreadyDeclaredException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(ParameterNotDeclaredException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(ParameterImmutableException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(ParameterModifiedInCallbackException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(ParameterUninitializedException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(QoSCheckCompatibleException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(InvalidParameterTypeException, std::runtime_error)
ROSWARD_DOUBLE_EXCEPTION(UninitializedStaticallyTypedParameterException, std::runtime_error)
#undef ROSWARD_DOUBLE_EXCEPTION
}  // namespace exceptions
}  // namespace rclcpp
