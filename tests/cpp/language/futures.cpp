// SPDX-License-Identifier: Apache-2.0

#include <future>
#include <thread>
#include <stdexcept>
#include <exception>


namespace futures_0 {
static void run() {
  std::promise<std::string> p; auto f = p.get_future(); p.set_exception(std::make_exception_ptr(std::runtime_error("no"))); try {show(std::string("futures0_") + (f.get()));} catch (const std::exception & e) {show(std::string("futures0_") + (std::string("caught_") + e.what()));}
}
}  // namespace futures_0

namespace futures_1 {
static void run() {
  auto f = std::async([] {throw std::runtime_error("x"); return std::string("v");}); try {show(std::string("futures1_") + (f.get()));} catch (const std::runtime_error & e) {show(std::string("futures1_") + (std::string("c") + e.what()));}
}
}  // namespace futures_1

namespace futures_2 {
static void run() {
  std::promise<int> p; auto f = p.get_future(); try {throw std::logic_error("le");} catch (...) {p.set_exception(std::current_exception());} try {show(std::string("futures2_") + ("n" + std::to_string(f.get())));} catch (const std::logic_error & e) {show(std::string("futures2_") + (std::string("c") + e.what()));}
}
}  // namespace futures_2

namespace futures_3 {
static void run() {
  std::exception_ptr e; try {throw std::out_of_range("oo");} catch (...) {e = std::current_exception();} try {if (e) std::rethrow_exception(e); show(std::string("futures3_") + ("none"));} catch (const std::out_of_range & x) {show(std::string("futures3_") + (std::string("re") + x.what()));}
}
}  // namespace futures_3

namespace futures_4 {
static void run() {
  std::promise<std::string> p; std::shared_future<std::string> f = p.get_future(); auto g = f; p.set_value("s"); show(std::string("futures4_") + (f.get() + g.get()));
}
}  // namespace futures_4

namespace futures_5 {
static void run() {
  std::promise<std::string> p; std::shared_future<std::string> f(p.get_future()); std::thread t([&p] {p.set_value("th");}); t.join(); show(std::string("futures5_") + (f.get()));
}
}  // namespace futures_5

namespace futures_6 {
static void run() {
  std::vector<std::future<int>> v; for (int i = 0; i < 3; ++i) v.push_back(std::async([i] {return i * i;})); int s = 0; for (auto & f : v) s += f.get(); show(std::string("futures6_") + ("n" + std::to_string(s)));
}
}  // namespace futures_6

namespace futures_7 {
static void run() {
  std::promise<std::string> p; auto f = p.get_future(); try {p.set_value("a"); throw 1;} catch (...) {} show(std::string("futures7_") + (f.get()));
}
}  // namespace futures_7

static void run()
{
  futures_0::run();
  futures_1::run();
  futures_2::run();
  futures_3::run();
  futures_4::run();
  futures_5::run();
  futures_6::run();
  futures_7::run();
}
