// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <iterator>

namespace numbers_0 {
static void run() {
  std::ostringstream o; uint8_t id = 65; o << "r" << id; show(std::string("numbers0_") + (o.str() + std::to_string(id)));
}
}  // namespace numbers_0

namespace numbers_1 {
static void run() {
  std::ostringstream o; int8_t id = 66; unsigned char c = 67; o << id << c << +id << static_cast<int>(c) << (id + 1); show(std::string("numbers1_") + ("n" + o.str()));
}
}  // namespace numbers_1

namespace numbers_2 {
struct P {uint8_t id = 70; std::vector<uint8_t> v{71, 72};};
static void w(std::ostream & o, uint8_t x) {o << x;}
static void run() {
  P p; std::ostringstream o; o << p.id << p.v[0]; w(o, 73); for (auto x : p.v) o << x; for (uint8_t i = 65; i < 67; ++i) o << i; show(std::string("numbers2_") + (o.str()));
}
}  // namespace numbers_2

namespace numbers_3 {
static void run() {
  std::vector<int> v; size_t n = v.size() - 1; show(std::string("numbers3_") + ("n" + std::to_string(n) + std::to_string(v.size() - 2)));
}
}  // namespace numbers_3

namespace numbers_4 {
static void run() {
  std::vector<int> v; std::string t; if (v.size() - 1 > 5) t += "wrap"; for (size_t i = 0; i < v.size() - 1 && i < 2; ++i) t += "x"; show(std::string("numbers4_") + ("n" + t));
}
}  // namespace numbers_4

namespace numbers_5 {
static void run() {
  unsigned a = 3, b = 5; show(std::string("numbers5_") + ("n" + std::to_string(a - b) + (a - b > 0 ? "p" : "m")));
}
}  // namespace numbers_5

namespace numbers_6 {
static void run() {
  std::string s = "ab"; show(std::string("numbers6_") + ("n" + std::to_string(s.find('z') + 1) + std::to_string(5 - static_cast<int>(s.size()))));
}
}  // namespace numbers_6

namespace numbers_7 {
static void run() {
  std::vector<int> v{1, 2, 3}; int n = v.size() - 1; int m = v.size() - 5; show(std::string("numbers7_") + ("n" + std::to_string(n) + std::to_string(m + 10) + std::to_string(v[v.size() - 1]) + std::to_string(*(v.begin() + (v.size() - 2)))));
}
}  // namespace numbers_7

namespace numbers_8 {
struct C {int n; int size() const {return n;}}; struct D {C c{1}; std::vector<int> v{1}; double off = 1.5; int64_t k = 2; std::string go() {std::string s; if (c.size() - 2 < 0) s += "neg"; if (v.size() - off < 0) s += "dbl"; if (v.size() - 2 > 100) s += "big"; return s;}};
static void run() {
  show(std::string("numbers8_") + ("n" + D().go()));
}
}  // namespace numbers_8

namespace numbers_9 {
static void run() {
  uint32_t a = 1; int64_t b = 3; uint8_t c = 1, d = 2; uint16_t e = 1; show(std::string("numbers9_") + ("n" + std::to_string(a - b + 10) + std::to_string(c - d + 5) + std::to_string(e - 2 + 9) + std::to_string(a - 2.5 + 3).substr(0, 1)));
}
}  // namespace numbers_9

namespace numbers_10 {
static void run() {
  std::string a = "x", b = "longer"; bool e = a.size() >= b.size() && a.compare(a.size() - b.size(), b.size(), b) == 0; size_t i = 5, j = 2; auto k = i - j; auto d = j - i; show(std::string("numbers10_") + (std::string(e ? "y" : "n") + std::to_string(k) + (d > 100 ? "w" : "s") + std::to_string((j - i) + 10)));
}
}  // namespace numbers_10

namespace numbers_11 {
static void run() {
  std::vector<std::string> v{"a", "b", "c"}; std::string s; for (int i = v.size() - 1; i >= 0; --i) s += v[i]; for (int i = static_cast<int>(v.size()) - 2; i >= 0; i--) s += v[i]; show(std::string("numbers11_") + (s + std::to_string(-1 * (int)(1 - v.size()))));
}
}  // namespace numbers_11

namespace numbers_12 {
static std::string f(unsigned) {return "u";} static std::string f(long) {return "l";} static std::string g(unsigned long) {return "ul";} static std::string g(int) {return "i";}
static std::string h(unsigned) {return "u";} static std::string h(int) {return "i";} static std::string h(double) {return "d";} static std::string h(size_t) {return "z";}
static void run() {
  size_t z = 3; uint32_t u = 3; show(std::string("numbers12_") + (f(1l) + f(1u) + g(1ul) + g(1) + h(2u) + h(2) + h(2.0) + h(z) + h(u) + h(sizeof(int)) + h(static_cast<uint32_t>(5)) + h(2.0f) + h('c') + h(true)));
}
}  // namespace numbers_12

namespace numbers_13 {
static std::string f(uint8_t) {return "u8";} static std::string f(int) {return "i";} static std::string f(const std::string &) {return "s";} static std::string g(double) {return "d";} static std::string g(uint64_t) {return "u64";} static std::string g(bool) {return "b";}
struct P {uint8_t a = 1; uint64_t b = 2; float c = 3;};
static void run() {
  P p; uint8_t k = 4; uint64_t m = 5; float q = 1; show(std::string("numbers13_") + (f(k) + f(p.a) + f(k + 1) + f("x") + f(uint8_t(3)) + g(m) + g(q) + g(p.c) + g(true)));
}
}  // namespace numbers_13

namespace numbers_14 {
struct Val {std::string t; Val(int) : t("int") {} Val(unsigned) : t("uint") {} Val(double) : t("dbl") {} Val(const char *) : t("cstr") {} Val(std::string) : t("str") {} Val(bool) : t("bool") {}};
static void run() {
  unsigned n = 2; show(std::string("numbers14_") + (Val(1).t + Val(n).t + Val(2.5).t + Val("x").t + Val(std::string("y")).t + Val(true).t + Val(3u).t));
}
}  // namespace numbers_14

namespace numbers_15 {
enum class Lvl {LOW = 1, MID = 2, HIGH = 4}; constexpr Lvl operator|(Lvl a, Lvl b) {return Lvl(int(a) | int(b));} constexpr bool has(Lvl v, Lvl f) {return (int(v) & int(f)) != 0;}
static void run() {
  auto v = Lvl::LOW | Lvl::HIGH; show(std::string("numbers15_") + (std::string(has(v, Lvl::MID) ? "m" : "_") + (has(v, Lvl::HIGH) ? "h" : "_")));
}
}  // namespace numbers_15

namespace numbers_16 {
struct Last {int at; long far; explicit Last(const std::vector<int> & v) : at(v.size() - 3), far(v.size() - 4) {} int of(unsigned n) {return n - 5;}};
static void into(unsigned n, int & out) {out = n - 6; out += n - 7;}
static void run() {
  std::vector<int> v{1}, kept; unsigned u = 1; Last l(v); int a = u - 2, b = 0, c = 0; int & r = c; r = u - 9; into(u, b); kept.push_back(u - 4); std::map<std::string, int> m; m["k"] = u - 8;
  auto add = [&] {a += u - 3;}; add(); int sum = static_cast<int>(u - 3) + l.at + l.of(u) + a + b + c + kept[0] + m["k"]; num("numbers16_", sum); num("numbers16_", l.far); num("numbers16_", std::max<int>(0, v.size() - 5) + std::clamp<int>(v.size() - 2, 0, 3));
}
}  // namespace numbers_16

namespace numbers_17 {
template<typename T> static std::string text(T n) {T m = n; return std::to_string(m);} template<typename T> static T twice(T n) {return n * 2;}
static void run() {
  unsigned a = 2, b = 5, c = 10; show(std::string("numbers17_") + (std::to_string(a - b + c) + "_" + std::to_string(c + (a - b)) + "_" + std::to_string((a - b) * 2 % 16)));
  show(std::string("numbers17_") + (text(4294967295u) + "_" + text(int64_t{1} << 40) + "_" + std::to_string(twice(3000000000ul)) + "_" + text(a - b)));
}
}  // namespace numbers_17

static void run()
{
  numbers_0::run();
  numbers_1::run();
  numbers_2::run();
  numbers_3::run();
  numbers_4::run();
  numbers_5::run();
  numbers_6::run();
  numbers_7::run();
  numbers_8::run();
  numbers_9::run();
  numbers_10::run();
  numbers_11::run();
  numbers_12::run();
  numbers_13::run();
  numbers_14::run();
  numbers_15::run();
  numbers_16::run();
  numbers_17::run();
}
