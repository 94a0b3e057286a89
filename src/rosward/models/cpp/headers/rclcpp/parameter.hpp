// SPDX-License-Identifier: Apache-2.0
// rclcpp::Parameter: a name and a value of one of nine types.
//
// A value stands in `_value` as the analysis holds it: a number, a text, a list. Read from rclcpp, branches humble, jazzy and
// rolling (parameter.hpp, parameter_value.hpp, parameter_map.hpp).

namespace rclcpp
{
class ParameterType
{
public:
  static const ParameterType PARAMETER_NOT_SET;
  static const ParameterType PARAMETER_BOOL;
  static const ParameterType PARAMETER_INTEGER;
  static const ParameterType PARAMETER_DOUBLE;
  static const ParameterType PARAMETER_STRING;
  static const ParameterType PARAMETER_BYTE_ARRAY;
  static const ParameterType PARAMETER_BOOL_ARRAY;
  static const ParameterType PARAMETER_INTEGER_ARRAY;
  static const ParameterType PARAMETER_DOUBLE_ARRAY;
  static const ParameterType PARAMETER_STRING_ARRAY;

  ParameterType(uint8_t number = 0) : _number(number) {}
  bool operator==(const ParameterType & other) const {return _number == other._number;}
  bool operator!=(const ParameterType & other) const {return _number != other._number;}
  operator uint8_t() const {return _number;}

  uint8_t _number;
};

const ParameterType PARAMETER_NOT_SET(0);
const ParameterType PARAMETER_BOOL(1);
const ParameterType PARAMETER_INTEGER(2);
const ParameterType PARAMETER_DOUBLE(3);
const ParameterType PARAMETER_STRING(4);
const ParameterType PARAMETER_BYTE_ARRAY(5);
const ParameterType PARAMETER_BOOL_ARRAY(6);
const ParameterType PARAMETER_INTEGER_ARRAY(7);
const ParameterType PARAMETER_DOUBLE_ARRAY(8);
const ParameterType PARAMETER_STRING_ARRAY(9);
const ParameterType ParameterType::PARAMETER_NOT_SET(0);
const ParameterType ParameterType::PARAMETER_BOOL(1);
const ParameterType ParameterType::PARAMETER_INTEGER(2);
const ParameterType ParameterType::PARAMETER_DOUBLE(3);
const ParameterType ParameterType::PARAMETER_STRING(4);
const ParameterType ParameterType::PARAMETER_BYTE_ARRAY(5);
const ParameterType ParameterType::PARAMETER_BOOL_ARRAY(6);
const ParameterType ParameterType::PARAMETER_INTEGER_ARRAY(7);
const ParameterType ParameterType::PARAMETER_DOUBLE_ARRAY(8);
const ParameterType ParameterType::PARAMETER_STRING_ARRAY(9);

std::string to_string(const ParameterType & type) {return rosward::parameter_word(type._number);}

class ParameterValue
{
public:
  ParameterValue() {}
  template<typename ValueT>
  explicit ParameterValue(const ValueT & value) : _value(rosward::parameter_value(value)) {}

  ParameterType get_type() const {return ParameterType(rosward::parameter_type(_value));}
  rcl_interfaces::msg::ParameterValue to_value_msg() const;
  bool operator==(const ParameterValue & rhs) const {return _value == rhs._value;}
  bool operator!=(const ParameterValue & rhs) const {return _value != rhs._value;}

  template<typename T>
  auto get() const {return rosward::parameter_as<T>(_value, "");}

  rosward::value _value;
};

std::string to_string(const ParameterValue & value) {return rosward::parameter_text(value._value);}

class Parameter
{
public:
  Parameter() {}
  explicit Parameter(const std::string & name) : _name(name) {}
  template<typename ValueT>
  Parameter(const std::string & name, const ValueT & value) : _name(name), _value(rosward::parameter_value(value)) {}

  bool operator==(const Parameter & rhs) const {return _name == rhs._name && _value == rhs._value;}
  bool operator!=(const Parameter & rhs) const {return !(*this == rhs);}

  ParameterType get_type() const {return ParameterType(rosward::parameter_type(_value));}
  std::string get_type_name() const {return rosward::parameter_word(rosward::parameter_type(_value));}
  const std::string & get_name() const {return _name;}
  ParameterValue get_parameter_value() const {return ParameterValue(_value);}
  rcl_interfaces::msg::ParameterValue get_value_message() const;

  template<typename T>
  auto get_value() const {return rosward::parameter_as<T>(_value, _name);}

  bool as_bool() const {return rosward::parameter_as<bool>(_value, _name);}
  int64_t as_int() const {return rosward::parameter_as<int64_t>(_value, _name);}
  double as_double() const {return rosward::parameter_as<double>(_value, _name);}
  auto as_string() const {return rosward::parameter_as<std::string>(_value, _name);}
  auto as_byte_array() const {return rosward::parameter_as<std::vector<uint8_t>>(_value, _name);}
  auto as_bool_array() const {return rosward::parameter_as<std::vector<bool>>(_value, _name);}
  auto as_integer_array() const {return rosward::parameter_as<std::vector<int64_t>>(_value, _name);}
  auto as_double_array() const {return rosward::parameter_as<std::vector<double>>(_value, _name);}
  auto as_string_array() const {return rosward::parameter_as<std::vector<std::string>>(_value, _name);}

  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter & parameter)
  {
    return Parameter(parameter.name, rosward::unknown("message", "value of a parameter"));
  }
  rcl_interfaces::msg::Parameter to_parameter_msg() const
  {
    rcl_interfaces::msg::Parameter message;
    message.name = _name;
    return message;
  }
  std::string value_to_string() const {return rosward::parameter_text(_value);}

  std::string _name;
  rosward::value _value;
};

using ParameterMap = std::unordered_map<std::string, std::vector<Parameter>>;
ParameterMap parameter_map_from_yaml_file(const std::string & yaml_filename);
std::vector<Parameter> parameters_from_map(const ParameterMap & parameter_map, const char * node_fqn = nullptr);
}  // namespace rclcpp
