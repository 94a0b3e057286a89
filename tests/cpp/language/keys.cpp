// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <unordered_map>
#include <queue>


namespace keys_0 {
struct Cmp {bool operator()(const std::string & a, const std::string & b) const {return a.size() < b.size();}};
static void run() {std::map<std::string, int, Cmp> m; m["ab"] = 1; m["cd"] = 2; m["x"] = 7; std::string t; for (auto & [k, v] : m) t += k + std::to_string(v); show(std::string("keys0_") + (t + std::to_string(m.size()) + std::to_string(m["xx"]) + (m.count("q") ? "y" : "n") + (m.find("qqq") == m.end() ? "y" : "n")));}
}  // namespace keys_0

namespace keys_1 {
struct Cmp {bool operator()(const std::string & a, const std::string & b) const {return a.size() < b.size();}};
static void run() {std::set<std::string, Cmp> m{"ab", "cd", "x"}; m.insert("ef"); std::string t; for (auto & k : m) t += k; t += std::to_string(m.size()) + *m.find("zz"); t += std::to_string(m.erase("qq")); t += std::to_string(m.size()); show(std::string("keys1_") + (t));}
}  // namespace keys_1

namespace keys_2 {
static void run() {
  auto cmp = [](const std::string & a, const std::string & b) {return a.back() < b.back();}; std::map<std::string, int, decltype(cmp)> m(cmp); m["a1"] = 1; m["b1"] = 2; m["c0"] = 3; show(std::string("keys2_") + (m.begin()->first + std::to_string(m.size()) + std::to_string(m.at("q1"))));
}
}  // namespace keys_2

namespace keys_3 {
static bool less(int a, int b) {return a / 10 < b / 10;}
static void run() {std::set<int, bool (*)(int, int)> s(&less); s.insert(25); s.insert(21); s.insert(13); show(std::string("keys3_") + ("n" + std::to_string(s.size()) + std::to_string(*s.begin()) + std::to_string(*s.rbegin())));}
}  // namespace keys_3

namespace keys_4 {
static void run() {
  std::set<int, std::function<bool(int, int)>> s([](int a, int b) {return a % 3 < b % 3;}); s.insert(4); s.insert(1); s.insert(3); show(std::string("keys4_") + ("n" + std::to_string(s.size()) + std::to_string(*s.begin()) + std::to_string(*s.rbegin())));
}
}  // namespace keys_4

namespace keys_5 {
static void run() {
  struct K {std::string n; int id; bool operator<(const K & o) const {return id < o.id;}}; std::map<K, std::string> m; m[K{"a", 1}] = "x"; m[K{"b", 1}] = "y"; m[K{"c", 0}] = "z"; std::string t; for (auto & [k, v] : m) t += k.n + v; t += std::to_string(m.size()); show(std::string("keys5_") + (t + m[K{"q", 1}]));
}
}  // namespace keys_5

namespace keys_6 {
static void run() {
  struct K {std::string n; int id; bool operator<(const K & o) const {return id < o.id;}}; std::set<K> m{{"a", 2}, {"b", 2}, {"c", 1}}; std::string t; for (auto & k : m) t += k.n; show(std::string("keys6_") + (t + std::to_string(m.size()) + std::to_string(m.count(K{"zz", 1}))));
}
}  // namespace keys_6

namespace keys_7 {
static void run() {
  struct Eq {bool operator()(const std::string & a, const std::string & b) const {return a[0] == b[0];}}; struct H {size_t operator()(const std::string & a) const {return a[0];}}; std::unordered_map<std::string, int, H, Eq> m; m["ab"] = 1; m["ac"] = 2; show(std::string("keys7_") + ("n" + std::to_string(m.size()) + std::to_string(m["aq"])));
}
}  // namespace keys_7

namespace keys_8 {
static void run() {
  struct K {int id; std::string n; bool operator==(const K & o) const {return id == o.id;}}; struct H {size_t operator()(const K & k) const {return k.id;}}; std::unordered_map<K, std::string, H> m; m[{1, "a"}] = "p"; m[{1, "b"}] = "q"; show(std::string("keys8_") + (m.begin()->first.n + m.begin()->second + std::to_string(m.size())));
}
}  // namespace keys_8

namespace keys_9 {
struct Cmp {bool operator()(const std::string & a, const std::string & b) const {return a.size() < b.size();}};
static void run() {std::multimap<std::string, int, Cmp> m; m.emplace("ab", 1); m.emplace("x", 3); m.emplace("cd", 2); std::string t; for (auto & [k, v] : m) t += k; show(std::string("keys9_") + (t + std::to_string(m.count("zz")) + std::to_string(m.lower_bound("qq")->second) + (m.find("zzzz") == m.end() ? "e" : "f")));}
}  // namespace keys_9

namespace keys_10 {
struct Cmp {bool operator()(const std::string & a, const std::string & b) const {return a.size() < b.size();}};
static void run() {std::multiset<std::string, Cmp> m{"bb", "a", "aa"}; std::string t; for (auto & k : m) t += k; show(std::string("keys10_") + (t + std::to_string(m.count("zz")) + *m.lower_bound("zz")));}
}  // namespace keys_10

namespace keys_11 {
static void run() {
  struct P {int x;}; struct Cmp {bool operator()(const std::shared_ptr<P> & a, const std::shared_ptr<P> & b) const {return a->x < b->x;}}; std::set<std::shared_ptr<P>, Cmp> s; s.insert(std::make_shared<P>(P{3})); s.insert(std::make_shared<P>(P{1})); s.insert(std::make_shared<P>(P{3})); show(std::string("keys11_") + ("n" + std::to_string(s.size()) + std::to_string((*s.begin())->x)));
}
}  // namespace keys_11

namespace keys_12 {
static void run() {
  std::map<std::string, int, std::greater<std::string>> m{{"a", 1}, {"b", 2}}; std::set<int, std::greater<>> s{1, 2, 3}; show(std::string("keys12_") + (m.begin()->first + std::to_string(*s.begin()) + std::to_string(*s.lower_bound(2)) + m.lower_bound("aa")->first));
}
}  // namespace keys_12

namespace keys_13 {
static void run() {
  struct T {std::string n; int p;}; auto c = [](const T & a, const T & b) {return a.p < b.p;}; std::priority_queue<T, std::vector<T>, decltype(c)> q(c); q.push({"lo", 1}); q.push({"hi", 9}); q.push({"mid", 5}); std::string t; while (!q.empty()) {t += q.top().n; q.pop();} show(std::string("keys13_") + (t));
}
}  // namespace keys_13

namespace keys_14 {
static void run() {
  struct K {int a, b; bool operator<(const K & o) const {return std::tie(a, b) < std::tie(o.a, o.b);}}; std::map<K, std::string> m{{{2, 1}, "x"}, {{1, 5}, "y"}, {{1, 3}, "z"}}; show(std::string("keys14_") + (m.begin()->second + m.rbegin()->second + m.at({1, 5})));
}
}  // namespace keys_14

namespace keys_15 {
struct K {int a; friend bool operator<(const K & x, const K & y) {return x.a > y.a;}};
static void run() {std::set<K> m{{1}, {3}, {2}}; show(std::string("keys15_") + ("n" + std::to_string(m.begin()->a)));}
}  // namespace keys_15

static void run()
{
  keys_0::run();
  keys_1::run();
  keys_2::run();
  keys_3::run();
  keys_4::run();
  keys_5::run();
  keys_6::run();
  keys_7::run();
  keys_8::run();
  keys_9::run();
  keys_10::run();
  keys_11::run();
  keys_12::run();
  keys_13::run();
  keys_14::run();
  keys_15::run();
}
