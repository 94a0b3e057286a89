// SPDX-License-Identifier: Apache-2.0
// std::enable_shared_from_this: an object that gives a pointer to itself.

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
}  // namespace std
