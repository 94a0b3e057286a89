// SPDX-License-Identifier: Apache-2.0

template <typename T> T maxi(T a, T b) { return a > b ? a : b; }
template <typename T> class Box {
  public:
  explicit Box(T v) : v_(v) {}
  T get() const { return v_; }
  static int kind() { return 1; }
  private:
  T v_;
};
template <int N> struct Fact { static constexpr int value = N * Fact<N - 1>::value; };
template <> struct Fact<0> { static constexpr int value = 1; };
template <typename ... T> int sum(T ... t) { return (t + ...); }
template <typename ... T> int count(T && ...) { return sizeof...(T); }
template <typename T, int N> struct Arr {
  T data[N];
  int size() { return N; }
  int fill(T x) { int s = 0; for (auto & d : data) { d = x; s += d; } return s; }
};
inline void print_all(const std::string &) {}
template <typename H, typename ... T> void print_all(const std::string & p, H h, T ... t) {
  num(p, h);
  print_all(p, t...);
}
template <typename F> int apply(F f, int x) { return f(x); }
template <typename T> int is_int() {
  if constexpr (std::is_same_v<T, int>) { return 1; } else { return 2; }
}
template <int N> constexpr int V = N * 10;
template <typename A, typename B> struct Pair { A first; B second; };
template <typename T> struct Traits { static constexpr int id = 1; };
template <> struct Traits<int> { static constexpr int id = 20; };
template <typename T> struct Traits<T *> { static constexpr int id = 300; };
template <typename T> int call_member(const T & t) { return t.get() + 1; }
template <typename ... T> std::string join(const T & ... t) { std::string r; ((r += t), ...); return r; }
template <typename T> struct Base { T v = 21; T get() { return v; } };
template <typename T> struct Derived : Base<T> { T twice() { return this->v + Base<T>::get(); } };
template <int N = 3> int def() { return N; }
template <typename Tuple, std::size_t ... I> int tuple_impl(const Tuple & t, std::index_sequence<I...>) {
  return (std::get<I>(t) + ...);
}
template <typename ... T> int tuple_sum(const std::tuple<T...> & t) {
  return tuple_impl(t, std::make_index_sequence<sizeof...(T)>{});
}
inline int target(int & x) { x++; return 1; }
inline int target(int && x) { return 2; }
template <typename T> int forwarder(T && t) { return target(std::forward<T>(t)); }
template <typename T> struct Nest { template <int M> struct In { static int n() { return M + 1; } }; };
template <typename ... T> constexpr int sizeof_pack() { return sizeof...(T); }
struct MA { int a() { return 1; } };
struct MB { int b() { return 2; } };
template <typename ... M> struct Mix : M ... {};
template <typename T> T conv(const char * s) { return T(s); }
inline int select(std::true_type) { return 1; }
inline int select(std::false_type) { return 10; }

void run()
{
  num("a", maxi(3, 4));
  show(maxi(std::string("b1"), std::string("b2")));
  num("c", maxi<double>(3, 4.5) * 2);
  Box<int> b(3);
  num("d", b.get());
  Box<std::string> s("e");
  show(s.get());
  Box d("deduced");
  num("f", Box<int>::kind());
  num("h", Fact<5>::value);
  num("i", sum(1, 2, 3, 4));
  num("j", count("a", 1, 2.0));
  Arr<int, 4> arr;
  num("k", arr.size());
  num("l", arr.fill(2));
  print_all("m", 1, 2, 3);
  num("n", apply([](int x) { return x + 1; }, 4));
  num("o", is_int<int>() + 10 * is_int<std::string>());
  num("p", V<3> + V<4>);
  Pair<int, std::string> p{1, "q"};
  show(p.second + std::to_string(p.first));
  num("r", Traits<float>::id + Traits<int>::id + Traits<int *>::id);
  num("s", call_member(b));
  show(join("t", "u", std::string("v")));
  num("w", Derived<int>().twice());
  num("x", def<>() + def<5>());
  int lv = 6;
  num("za", forwarder(lv));
  num("zb", lv);
  using Vec = std::vector<Box<int>>;
  Vec vec;
  vec.emplace_back(8);
  num("zc", vec[0].get());
  num("zd", Nest<int>::In<2>::n());
  num("ze", sizeof_pack<int, char, long>());
  Mix<MA, MB> mix;
  num("zf", mix.a() + mix.b());
  num("zg", conv<std::string>("x").size());
}
