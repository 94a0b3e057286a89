// SPDX-License-Identifier: Apache-2.0
// What all generated messages share.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rosidl_runtime_cpp
{
enum class MessageInitialization { ALL, SKIP, ZERO, DEFAULTS_ONLY };
// A sequence with a most length.
template<typename T, size_t most, typename A = std::allocator<T>>
class BoundedVector : public std::vector<T, A>
{
public:
  using std::vector<T, A>::vector;
};
}  // namespace rosidl_runtime_cpp

namespace rosidl_generator_traits
{
template<typename T>
const char * name();
template<typename T>
const char * data_type()
{
  return name<T>();
}
}  // namespace rosidl_generator_traits

#define ROSWARD_DOUBLE_POINTERS(NAME) \
  using SharedPtr = std::shared_ptr<NAME>; \
  using ConstSharedPtr = std::shared_ptr<const NAME>; \
  using UniquePtr = std::unique_ptr<NAME>; \
  using ConstUniquePtr = std::unique_ptr<const NAME>; \
  using WeakPtr = std::weak_ptr<NAME>;

#define ROSWARD_DOUBLE_TYPE(TYPE, TEXT) \
  namespace rosidl_generator_traits \
  { \
  template<> \
  inline const char * name<TYPE>() \
  { \
    return TEXT; \
  } \
  }
