// SPDX-License-Identifier: Apache-2.0
// Parameters and their values.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/parameter_type.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
enum ParameterType : uint8_t
{
  PARAMETER_NOT_SET = 0,
  PARAMETER_BOOL = 1,
  PARAMETER_INTEGER = 2,
  PARAMETER_DOUBLE = 3,
  PARAMETER_STRING = 4,
  PARAMETER_BYTE_ARRAY = 5,
  PARAMETER_BOOL_ARRAY = 6,
  PARAMETER_INTEGER_ARRAY = 7,
  PARAMETER_DOUBLE_ARRAY = 8,
  PARAMETER_STRING_ARRAY = 9,
};

std::string to_string(ParameterType type);

// The type in which a value of type T is kept.
template<typename T, typename = void>
struct Kept
{
};
template<>
struct Kept<bool>
{
  using type = bool;
};
template<typename T>
struct Kept<T, std::enable_if_t<std::is_integral_v<T> && !std::is_same_v<T, bool>>>
{
  using type = int64_t;
};
template<typename T>
struct Kept<T, std::enable_if_t<std::is_floating_point_v<T>>>
{
  using type = double;
};
template<typename T>
struct Kept<T, std::enable_if_t<std::is_convertible_v<T, std::string>>>
{
  using type = std::string;
};
template<>
struct Kept<std::vector<uint8_t>>
{
  using type = std::vector<uint8_t>;
};
template<>
struct Kept<std::vector<bool>>
{
  using type = std::vector<bool>;
};
template<>
struct Kept<std::vector<std::string>>
{
  using type = std::vector<std::string>;
};
template<typename T>
struct Kept<std::vector<T>, std::enable_if_t<std::is_integral_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, uint8_t>>>
{
  using type = std::vector<int64_t>;
};
template<typename T>
struct Kept<std::vector<T>, std::enable_if_t<std::is_floating_point_v<T>>>
{
  using type = std::vector<double>;
};

class ParameterValue
{
public:
  using Data = std::variant<
    std::monostate, bool, int64_t, double, std::string, std::vector<uint8_t>, std::vector<bool>, std::vector<int64_t>,
    std::vector<double>, std::vector<std::string>>;

  ParameterValue() = default;
  template<typename T, typename K = typename Kept<T>::type>
  explicit ParameterValue(const T & value) : data_(K(converted<K>(value)))
  {
  }
  ParameterType get_type() const { return static_cast<ParameterType>(data_.index()); }
  bool operator==(const ParameterValue & other) const { return data_ == other.data_; }
  bool operator!=(const ParameterValue & other) const { return data_ != other.data_; }

  template<typename T>
  const typename Kept<T>::type & get() const
  {
    using K = typename Kept<T>::type;
    if (auto found = std::get_if<K>(&data_)) {
      return *found;
    }
    wrong_type(static_cast<ParameterType>(Data(K()).index()));
  }
  template<ParameterType type>
  const auto & get() const
  {
    return get<std::variant_alternative_t<type, Data>>();
  }

private:
  template<typename K, typename T>
  static K converted(const T & value)
  {
    if constexpr (std::is_arithmetic_v<K> || std::is_same_v<K, std::string>) {
      return static_cast<K>(value);
    } else {
      return K(value.begin(), value.end());
    }
  }
  [[noreturn]] void wrong_type(ParameterType expected) const;
  Data data_;
};

std::string to_string(const ParameterValue & value);

class Parameter
{
public:
  Parameter() = default;
  explicit Parameter(const std::string & name) : name_(name) {}
  Parameter(const std::string & name, const ParameterValue & value) : name_(name), value_(value) {}
  template<typename T>
  Parameter(const std::string & name, T value) : name_(name), value_(ParameterValue(value))
  {
  }
  bool operator==(const Parameter & other) const { return name_ == other.name_ && value_ == other.value_; }
  bool operator!=(const Parameter & other) const { return !(*this == other); }

  ParameterType get_type() const { return value_.get_type(); }
  std::string get_type_name() const { return to_string(get_type()); }
  const std::string & get_name() const { return name_; }
  const ParameterValue & get_parameter_value() const { return value_; }
  std::string value_to_string() const { return to_string(value_); }
  rcl_interfaces::msg::Parameter to_parameter_msg() const;

  template<typename T>
  decltype(auto) get_value() const
  {
    try {
      return value_.template get<T>();
    } catch (const ParameterTypeException & error) {
      throw exceptions::InvalidParameterTypeException("parameter '" + name_ + "': " + error.what());
    }
  }
  template<ParameterType type>
  decltype(auto) get_value() const
  {
    return get_value<std::variant_alternative_t<type, ParameterValue::Data>>();
  }
  bool as_bool() const { return get_value<bool>(); }
  int64_t as_int() const { return get_value<int64_t>(); }
  double as_double() const { return get_value<double>(); }
  const std::string & as_string() const { return get_value<std::string>(); }
  const std::vector<uint8_t> & as_byte_array() const { return get_value<std::vector<uint8_t>>(); }
  const std::vector<bool> & as_bool_array() const { return get_value<std::vector<bool>>(); }
  const std::vector<int64_t> & as_integer_array() const { return get_value<std::vector<int64_t>>(); }
  const std::vector<double> & as_double_array() const { return get_value<std::vector<double>>(); }
  const std::vector<std::string> & as_string_array() const { return get_value<std::vector<std::string>>(); }

private:
  std::string name_;
  ParameterValue value_;
};

namespace node_interfaces
{
struct OnSetParametersCallbackHandle
{
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
  using Callback = std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)>;
  Callback callback;
};
struct PostSetParametersCallbackHandle
{
  using SharedPtr = std::shared_ptr<PostSetParametersCallbackHandle>;
  using Callback = std::function<void(const std::vector<Parameter> &)>;
  Callback callback;
};
struct PreSetParametersCallbackHandle
{
  using SharedPtr = std::shared_ptr<PreSetParametersCallbackHandle>;
  using Callback = std::function<void(std::vector<Parameter> &)>;
  Callback callback;
};
}  // namespace node_interfaces
}  // namespace rclcpp

namespace rosward_double
{
// The parameters of a node.
struct Parameters
{
  struct Declared
  {
    rclcpp::ParameterValue value;
    rcl_interfaces::msg::ParameterDescriptor descriptor;
  };
  bool allow_undeclared = false;
  std::map<std::string, rclcpp::ParameterValue> overrides;
  std::map<std::string, Declared> declared;
  std::vector<std::weak_ptr<rclcpp::node_interfaces::OnSetParametersCallbackHandle>> on_set;
  std::vector<std::weak_ptr<rclcpp::node_interfaces::PostSetParametersCallbackHandle>> post_set;
  std::vector<std::weak_ptr<rclcpp::node_interfaces::PreSetParametersCallbackHandle>> pre_set;

  // `type` is what the value has to be, NOT_SET where it may be anything.
  const rclcpp::ParameterValue & declare(
    Core & node, const std::string & name, rclcpp::ParameterType type, const rclcpp::ParameterValue & given,
    const rcl_interfaces::msg::ParameterDescriptor & descriptor, bool ignore_override);
  rclcpp::Parameter get(const std::string & name) const;
  bool get(const std::string & name, rclcpp::Parameter & found) const;
  // Somebody sets each that the program has declared, where it is observed.
  void change(Core & node, int turn);
  std::vector<rcl_interfaces::msg::SetParametersResult> set(Core & node, std::vector<rclcpp::Parameter> changed, bool together);

private:
  rcl_interfaces::msg::SetParametersResult apply(Core & node, const std::vector<rclcpp::Parameter> & changed);
  rcl_interfaces::msg::SetParametersResult ask(const std::vector<rclcpp::Parameter> & changed) const;
};
}  // namespace rosward_double
