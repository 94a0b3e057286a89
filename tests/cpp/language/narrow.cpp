// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <typeinfo>


namespace narrow_0 {
static void run() {
  unsigned char u = 255; u++; show(std::string("narrow0_") + ("n" + std::to_string(u)));
}
}  // namespace narrow_0

namespace narrow_1 {
static void run() {
  signed char c = 127; c += 1; short sh = 40000; show(std::string("narrow1_") + (std::string(c < 0 ? "neg" : "pos") + (sh < 0 ? "neg" : "pos")));
}
}  // namespace narrow_1

namespace narrow_2 {
static void run() {
  unsigned x = -1; show(std::string("narrow2_") + ("n" + std::to_string(x)));
}
}  // namespace narrow_2

namespace narrow_3 {
static void run() {
  long long ll = 1e10; int i = 3.99; show(std::string("narrow3_") + ("n" + std::to_string(ll) + std::to_string(i)));
}
}  // namespace narrow_3

namespace narrow_4 {
static void run() {
  struct S {uint8_t b = 250;}; S s; s.b += 10; s.b++; uint8_t arr[2] = {255, 0}; arr[0]++; arr[1]--; std::vector<uint8_t> v{300 & 0xff, 1}; v[1] -= 2; show(std::string("narrow4_") + ("n" + std::to_string(s.b) + "_" + std::to_string(arr[0]) + "_" + std::to_string(arr[1]) + "_" + std::to_string(v[1])));
}
}  // namespace narrow_4

namespace narrow_5 {
static void run() {
  auto f = [](uint8_t x) {return x;}; auto g = [](int x) -> uint8_t {return x;}; show(std::string("narrow5_") + ("n" + std::to_string(f(257)) + std::to_string(g(258)) + std::to_string(uint8_t(259)) + std::to_string((uint8_t)260)));
}
}  // namespace narrow_5

namespace narrow_6 {
static void run() {
  int8_t i = -1; uint32_t u = i; int32_t back = u; show(std::string("narrow6_") + ("n" + std::to_string(u) + std::to_string(-back)));
}
}  // namespace narrow_6

namespace narrow_7 {
static void run() {
  uint64_t m = 0; m--; show(std::string("narrow7_") + ("n" + std::to_string(m)));
}
}  // namespace narrow_7

namespace narrow_8 {
static void run() {
  uint8_t x = 0x80; x <<= 1; uint8_t y = ~0x0f; show(std::string("narrow8_") + ("n" + std::to_string(x) + "_" + std::to_string(y)));
}
}  // namespace narrow_8

namespace narrow_9 {
static void run() {
  union U {struct {int x, y;} p; int v[2];}; U u; u.p.x = 5; u.p.y = 6; show(std::string("narrow9_") + ("n" + std::to_string(u.p.x) + std::to_string(u.p.y)));
}
}  // namespace narrow_9

namespace narrow_10 {
static void run() {
  struct T {union {struct {int x, y;}; int d[2];}; int k = 3;}; T t; t.d[0] = 2; t.d[1] = 3; show(std::string("narrow10_") + ("n" + std::to_string(t.d[0] + t.d[1]) + std::to_string(t.k)));
}
}  // namespace narrow_10

namespace narrow_11 {
static void run() {
  union U {int i; float f;}; U u; u.i = 7; U w = u; w.f = 1; show(std::string("narrow11_") + ("n" + std::to_string(u.i)));
}
}  // namespace narrow_11

namespace narrow_12 {
static void run() {
  struct T {int a; union {int i; float f;}; int k = 3;}; T t{1, 2, 4}; T s{1}; show(std::string("narrow12_") + ("n" + std::to_string(t.a) + std::to_string(t.i) + std::to_string(t.k) + std::to_string(s.k)));
}
}  // namespace narrow_12

namespace narrow_13 {
static void run() {
  struct T {int a; union {struct {int i;} p; int q[1];}; int k;}; T t{1, {{2}}, 4}; show(std::string("narrow13_") + ("n" + std::to_string(t.a) + std::to_string(t.p.i) + std::to_string(t.k)));
}
}  // namespace narrow_13

namespace narrow_14 {
static void run() {
  struct A {virtual ~A() = default;}; struct B : A {}; struct C : A {std::string s = "C";}; B b; A & r = b; try {C & c = dynamic_cast<C &>(r); show(std::string("narrow14_") + (c.s));} catch (const std::bad_cast &) {show(std::string("narrow14_") + ("bad"));}
}
}  // namespace narrow_14

namespace narrow_15 {
static void run() {
  struct A {virtual ~A() = default;}; struct C : A {std::string s = "C";}; C b; A & r = b; try {show(std::string("narrow15_") + (dynamic_cast<C &>(r).s));} catch (const std::bad_cast &) {show(std::string("narrow15_") + ("bad"));}
}
}  // namespace narrow_15

static void run()
{
  narrow_0::run();
  narrow_1::run();
  narrow_2::run();
  narrow_3::run();
  narrow_4::run();
  narrow_5::run();
  narrow_6::run();
  narrow_7::run();
  narrow_8::run();
  narrow_9::run();
  narrow_10::run();
  narrow_11::run();
  narrow_12::run();
  narrow_13::run();
  narrow_14::run();
  narrow_15::run();
}
