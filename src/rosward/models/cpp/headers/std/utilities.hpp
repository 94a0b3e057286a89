// SPDX-License-Identifier: Apache-2.0
// std: bits, tasks that keep what they give, numbers that are read from characters.

namespace std
{
// What a variant holds that holds nothing.
struct monostate {};
inline bool operator==(const monostate &, const monostate &) {return true;}
inline bool operator!=(const monostate &, const monostate &) {return false;}

template<size_t N>
class bitset
{
public:
  bitset() : _bits(N, '0') {}
  bitset(unsigned long long number) : _bits(N, '0')
  {
    for (size_t i = 0; i < N && number > 0; ++i, number /= 2) {
      _bits[N - 1 - i] = number % 2 ? '1' : '0';
    }
  }
  bitset(const std::string & text) : _bits(text.size() < N ? std::string(N - text.size(), '0') + text : text.substr(0, N)) {}
  bool test(size_t i) const
  {
    if (i >= N) {
      throw std::out_of_range("bitset");
    }
    return _bits[N - 1 - i] == '1';
  }
  bool operator[](size_t i) const {return _bits[N - 1 - i] == '1';}
  bitset & set()
  {
    _bits = std::string(N, '1');
    return *this;
  }
  bitset & set(size_t i, bool value = true)
  {
    _bits[N - 1 - i] = value ? '1' : '0';
    return *this;
  }
  bitset & reset()
  {
    _bits = std::string(N, '0');
    return *this;
  }
  bitset & reset(size_t i) {return set(i, false);}
  bitset & flip(size_t i) {return set(i, !test(i));}
  size_t size() const {return N;}
  size_t count() const {return std::count(_bits.begin(), _bits.end(), '1');}
  bool any() const {return count() > 0;}
  bool none() const {return count() == 0;}
  bool all() const {return count() == N;}
  std::string to_string() const {return _bits;}
  unsigned long to_ulong() const
  {
    unsigned long number = 0;
    for (char bit : _bits) {
      number = number * 2 + (bit == '1' ? 1 : 0);
    }
    return number;
  }
  unsigned long long to_ullong() const {return to_ulong();}
  bool operator==(const bitset & other) const {return _bits == other._bits;}
  bool operator!=(const bitset & other) const {return _bits != other._bits;}

private:
  std::string _bits;
};

template<typename SignatureT>
class packaged_task
{
public:
  packaged_task() {}
  template<typename CallableT>
  packaged_task(CallableT callable) : _callable(callable) {}
  auto get_future() {return _promise.get_future();}
  template<typename ... Args>
  void operator()(Args && ... args) {_promise.set_value(_callable(std::forward<Args>(args) ...));}
  bool valid() const {return static_cast<bool>(_callable);}

private:
  std::function<SignatureT> _callable;
  std::promise<void> _promise;
};

struct from_chars_result
{
  const char * ptr;
  std::errc ec;
};
template<typename NumberT>
from_chars_result from_chars(const char * first, const char * last, NumberT & value, int base = 10)
{
  std::string text(first);
  text = text.substr(0, text.size() - std::string(last).size());
  if (text.empty() || text[0] == ' ' || text[0] == '+') {
    return {first, static_cast<std::errc>(22)};
  }
  try {
    size_t end = 0;
    if constexpr (std::is_floating_point_v<NumberT>) {
      value = std::stod(text, &end);
    } else {
      value = std::stoll(text, &end, base);
    }
    return {first + end, static_cast<std::errc>(0)};
  } catch (const std::invalid_argument &) {
    return {first, static_cast<std::errc>(22)};
  } catch (const std::out_of_range &) {
    return {first, static_cast<std::errc>(34)};
  }
}
template<class Order>
bool is_eq(Order order)
{
  return order == 0;
}
template<class Order>
bool is_neq(Order order)
{
  return order != 0;
}
template<class Order>
bool is_lt(Order order)
{
  return order < 0;
}
template<class Order>
bool is_lteq(Order order)
{
  return order <= 0;
}
template<class Order>
bool is_gt(Order order)
{
  return order > 0;
}
template<class Order>
bool is_gteq(Order order)
{
  return order >= 0;
}
}  // namespace std
