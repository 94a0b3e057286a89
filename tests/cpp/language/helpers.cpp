// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bitset>
#include <future>
#include <iterator>
#include <list>
#include <cstdio>

namespace helpers_0 {
struct C {std::string who() {return __func__;}};
static std::string free_one() {return __func__;}
static void run() {
  show(std::string("helpers0_") + (C().who() + free_one() + std::string(__FUNCTION__)));
}
}  // namespace helpers_0

namespace helpers_1 {
static void run() {
  std::vector<int> a{1, 2}, b{1, 3}; show(std::string("helpers1_") + (std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end()) ? "less" : "not"));
}
}  // namespace helpers_1

namespace helpers_2 {
static void run() {
  std::variant<int, double, std::string> v = 2.5; std::string s = std::to_string(v.index()); v = "s"; show(std::string("helpers2_") + ("m" + s + std::to_string(v.index())));
}
}  // namespace helpers_2

namespace helpers_3 {
static void run() {
  std::vector<int> a{1, 2, 3}, b{1, 5, 3}; auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin()); show(std::string("helpers3_") + ("n" + std::to_string(*x) + std::to_string(*y) + std::to_string(x - a.begin())));
}
}  // namespace helpers_3

namespace helpers_4 {
static void run() {
  std::bitset<8> b(5); b.set(1); show(std::string("helpers4_") + ("n" + b.to_string() + std::to_string(b.count()) + std::to_string(b.to_ulong())));
}
}  // namespace helpers_4

namespace helpers_5 {
static void run() {
  std::packaged_task<std::string(int)> t([](int n) {return "p" + std::to_string(n);}); auto f = t.get_future(); t(4); show(std::string("helpers5_") + (f.get()));
}
}  // namespace helpers_5

namespace helpers_6 {
template<typename ... Args>
std::string string_format(const std::string & format, Args ... args)
{
  int size_s = std::snprintf(nullptr, 0, format.c_str(), args ...) + 1;
  if (size_s <= 0) {throw std::runtime_error("Error during formatting.");}
  auto size = static_cast<size_t>(size_s);
  std::unique_ptr<char[]> buf(new char[size]);
  std::snprintf(buf.get(), size, format.c_str(), args ...);
  return std::string(buf.get(), buf.get() + size - 1);
}
static void run() {
  show(std::string("helpers6_") + (string_format("m_%d_%s", 3, "x")));
}
}  // namespace helpers_6

namespace helpers_7 {
template<typename... A> std::string fmt(const std::string & f, A... a) {std::vector<char> b(128); int n = snprintf(b.data(), b.size(), f.c_str(), a...); return std::string(b.data(), n);}
static void run() {
  show(std::string("helpers7_") + (fmt("v_%s_%02d", "z", 7)));
}
}  // namespace helpers_7

namespace helpers_8 {
template<typename... A> std::string fmt(const std::string & f, A... a) {std::string b; b.resize(64); int n = snprintf(&b[0], b.size(), f.c_str(), a...); b.resize(n); return b;}
static void run() {
  show(std::string("helpers8_") + (fmt("v_%s_%02d", "z", 7)));
}
}  // namespace helpers_8

namespace helpers_9 {
static void run() {
  std::list<std::string> l{"a", "b", "c"}; l.splice(l.begin(), l, std::prev(l.end())); show(std::string("helpers9_") + ("q" + std::to_string(l.size()) + l.front()));
}
}  // namespace helpers_9

namespace helpers_10 {
static void run() {
  std::list<std::string> l{"a", "b", "c"}, k{"z"}; l.splice(l.end(), k); std::string s; for (auto & e : l) s += e; show(std::string("helpers10_") + ("q" + s + std::to_string(k.size())));
}
}  // namespace helpers_10

static void run()
{
  helpers_0::run();
  helpers_1::run();
  helpers_2::run();
  helpers_3::run();
  helpers_4::run();
  helpers_5::run();
  helpers_6::run();
  helpers_7::run();
  helpers_8::run();
  helpers_9::run();
  helpers_10::run();
}
