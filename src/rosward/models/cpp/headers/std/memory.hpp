// SPDX-License-Identifier: Apache-2.0
// std::enable_shared_from_this: an object that gives a pointer to itself; pointers that threads share.

namespace std
{
template<class T>
class enable_shared_from_this
{
public:
  enable_shared_from_this() {}
  std::shared_ptr<T> shared_from_this() {return this;}
  std::shared_ptr<const T> shared_from_this() const {return this;}
  std::weak_ptr<T> weak_from_this() {return this;}
};
template<class T>
std::shared_ptr<T> atomic_load(const std::shared_ptr<T> * pointer) {return *pointer;}
template<class T>
std::shared_ptr<T> atomic_load_explicit(const std::shared_ptr<T> * pointer, std::memory_order order) {return *pointer;}
template<class T>
void atomic_store(std::shared_ptr<T> * pointer, std::shared_ptr<T> value) {*pointer = value;}
template<class T>
void atomic_store_explicit(std::shared_ptr<T> * pointer, std::shared_ptr<T> value, std::memory_order order)
{
  *pointer = value;
}
template<class T>
std::shared_ptr<T> atomic_exchange(std::shared_ptr<T> * pointer, std::shared_ptr<T> value)
{
  auto before = *pointer;
  *pointer = value;
  return before;
}
}  // namespace std
