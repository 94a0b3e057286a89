// SPDX-License-Identifier: Apache-2.0
// What arrives, and what leaves. By default all that arrives has default values, and nothing is said of what leaves.
//
// With ROSWARD_DOUBLE_VARY in the environment (`topic:/in=2 parameter:p=1`, or empty), each input has contents of its own, the same for the
// same name, turn and variant; what arrives and leaves is a line of the standard output:  @double comes topic:/in    @double said topic:/out {data=1.5 }
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "rosward_double/core.hpp"

namespace rosward_double
{
bool observed();
void said(const std::string & sink, const std::string & content);

// Chooses the contents of one arrival.
class Contents
{
public:
  Contents(const std::string & source, int turn);
  int64_t choose(int64_t most);
  double number();
  std::string text();

private:
  uint64_t state_;
};

template<typename T, typename = void>
struct HasFields : std::false_type
{
};
struct AnyField
{
  template<typename T>
  void operator()(const char *, T &&) const
  {
  }
};
template<typename T>
struct HasFields<T, std::void_t<decltype(T::rosward_double_fields(std::declval<T &>(), AnyField()))>> : std::true_type
{
};
template<typename T>
struct IsArray : std::false_type
{
};
template<typename T, size_t n>
struct IsArray<std::array<T, n>> : std::true_type
{
};

template<typename T>
void fill(T & value, Contents & contents)
{
  if constexpr (std::is_same_v<T, bool>) {
    value = contents.choose(2) == 1;
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(contents.number());
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(contents.choose(7));
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = contents.text();
  } else if constexpr (IsArray<T>::value) {
    for (auto & each : value) {
      fill(each, contents);
    }
  } else if constexpr (HasFields<T>::value) {
    T::rosward_double_fields(value, [&contents](const char *, auto & field) { fill(field, contents); });
  } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::u16string>) {
    using Element = typename T::value_type;
    value.resize(std::is_floating_point_v<Element> ? 3 : 1 + contents.choose(4));
    for (size_t i = 0; i < value.size(); i++) {
      Element each{};
      fill(each, contents);
      value[i] = each;
    }
  }
}

template<typename T>
void tell(std::ostream & out, const T & value)
{
  if constexpr (std::is_same_v<T, std::string>) {
    out << '"';
    for (const char c : value) {
      out << (c < ' ' ? '?' : c);
    }
    out << '"';
  } else if constexpr (std::is_floating_point_v<T>) {
    out.precision(9);
    out << value;
  } else if constexpr (std::is_integral_v<T>) {
    out << static_cast<int64_t>(value);
  } else if constexpr (HasFields<T>::value) {
    out << '{';
    T::rosward_double_fields(value, [&out](const char * name, const auto & field) {
        out << name << '=';
        tell(out, field);
        out << ' ';
      });
    out << '}';
  } else if constexpr (std::is_convertible_v<T, std::string>) {
    tell(out, std::string(value));
  } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::u16string>) {
    out << '[';
    for (const auto & each : value) {
      tell(out, each);
      out << ' ';
    }
    out << ']';
  }
}

template<typename T>
void arrive(const std::string & source, int turn, T & value)
{
  if constexpr (HasFields<T>::value) {
    if (observed()) {
      Contents contents(source, turn);
      fill(value, contents);
    }
  }
}

template<typename T>
void leave(const std::string & sink, const T & value)
{
  if constexpr (HasFields<T>::value) {
    if (observed()) {
      std::ostringstream text;
      tell(text, value);
      said(sink, text.str());
    }
  }
}
}  // namespace rosward_double
