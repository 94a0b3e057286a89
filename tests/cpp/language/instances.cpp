// SPDX-License-Identifier: Apache-2.0


namespace instances_0 {
template <int I> struct N {static const std::string name; std::string f() {return "gen";} static std::string g(int k) {return "g" + std::to_string(k + I);} int v = I;};
template <> const std::string N<1>::name = "one";
template <> const std::string N<2>::name = "two";
template <> std::string N<1>::f() {return "f1" + std::to_string(v);}
template <> std::string N<2>::g(int k) {return "special" + std::to_string(k);}
static void run() {show(std::string("instances0_") + (N<1>::name + N<2>::name + N<1>().f() + N<2>().f() + N<1>::g(3) + N<2>::g(3)));}
}  // namespace instances_0

namespace instances_1 {
template <typename T> struct N {static const std::string name; static int count; N() {++count;}};
template <typename T> const std::string N<T>::name = "any"; template <typename T> int N<T>::count = 0;
template <> const std::string N<int>::name = "int"; template <> int N<char>::count = 10;
static void run() {N<int> a, b; N<char> c; show(std::string("instances1_") + (N<int>::name + N<double>::name + std::to_string(N<int>::count) + std::to_string(N<char>::count)));}
}  // namespace instances_1

namespace instances_2 {
struct A {static const int k = 3; static const std::string s;}; const int A::k; const std::string A::s = "str";
static void run() {show(std::string("instances2_") + (A::s + std::to_string(A::k)));}
}  // namespace instances_2

namespace instances_3 {
struct Imu {}; struct Scan {};
template <typename M> class Pub {public: std::string topic() const; static constexpr int depth() {return 10;}};
template <typename M> std::string Pub<M>::topic() const {return "default";}
template <> std::string Pub<Imu>::topic() const {return "imu";}
template <> constexpr int Pub<Scan>::depth() {return 5;}
static void run() {show(std::string("instances3_") + (Pub<Imu>().topic() + Pub<Scan>().topic() + std::to_string(Pub<Imu>::depth()) + std::to_string(Pub<Scan>::depth())));}
}  // namespace instances_3

namespace instances_4 {
template <std::size_t I = 0, typename... T> std::string each(const std::tuple<T...> & t) {if constexpr (I == sizeof...(T)) return ""; else return std::to_string(std::get<I>(t)) + "_" + each<I + 1>(t);}
static void run() {show(std::string("instances4_") + ("n" + each(std::make_tuple(1, 2, 3))));}
}  // namespace instances_4

static void run()
{
  instances_0::run();
  instances_1::run();
  instances_2::run();
  instances_3::run();
  instances_4::run();
}
