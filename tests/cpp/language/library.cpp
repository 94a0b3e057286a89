// SPDX-License-Identifier: Apache-2.0

#include <any>
#include <iterator>
#include <stdexcept>


namespace library_0 {
static void run() {
  std::string s = "x"; try {s.substr(5);} catch (const std::out_of_range &) {s += "oor";} try {s.at(99);} catch (...) {s += "at";} try {s.erase(50);} catch (...) {s += "er";} show(std::string("library0_") + (s));
}
}  // namespace library_0

namespace library_1 {
static void run() {
  size_t pos = 0; int v = std::stoi("12ab", &pos); std::string s; try {std::stoi("99999999999");} catch (const std::out_of_range &) {s = "big";} show(std::string("library1_") + (s + std::to_string(v) + std::to_string(pos)));
}
}  // namespace library_1

namespace library_2 {
static void run() {
  std::stringstream ss("1 abc 2.5 x"); int a; std::string b; double c; char d; ss >> a >> b >> c >> d; int e = 9; bool ok = static_cast<bool>(ss >> e); show(std::string("library2_") + (b + std::to_string(a) + std::to_string(static_cast<int>(c * 2)) + d + (ok ? "y" : "n") + std::to_string(e)));
}
}  // namespace library_2

namespace library_3 {
static void run() {
  std::vector<std::string> v{"bb", "a", "ccc"}; std::stable_sort(v.begin(), v.end(), [](auto & a, auto & b) {return a.size() > b.size();}); std::string s; std::copy(v.begin(), v.end(), std::back_inserter(v)); std::istringstream is("p q r"); std::vector<std::string> w{std::istream_iterator<std::string>(is), std::istream_iterator<std::string>()}; std::rotate(w.begin(), w.begin() + 1, w.end()); for (auto & x : w) s += x; show(std::string("library3_") + (s + v[0] + std::to_string(w.size()) + std::to_string(v.size())));
}
}  // namespace library_3

namespace library_4 {
static void run() {
  std::any a = std::string("st"); std::string s; try {std::any_cast<int>(a);} catch (const std::bad_any_cast &) {s += "bad";} show(std::string("library4_") + (s));
}
}  // namespace library_4

static void run()
{
  library_0::run();
  library_1::run();
  library_2::run();
  library_3::run();
  library_4::run();
}
