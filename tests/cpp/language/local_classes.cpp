// SPDX-License-Identifier: Apache-2.0


namespace local_classes_0 {
static void run() {
  struct A {virtual ~A() = default; std::string n() {return "A" + m();} virtual std::string m() {return "a";}}; struct B : A {std::string m() override {return "b";}}; B c; show(std::string("local_classes0_") + (c.n()));
}
}  // namespace local_classes_0

namespace local_classes_1 {
static void run() {
  struct A {std::string s = "fa";}; struct B : A {}; B b; show(std::string("local_classes1_") + (b.s));
}
}  // namespace local_classes_1

namespace local_classes_2 {
static void run() {
  struct A {std::string s = "fa";}; struct B : A {}; show(std::string("local_classes2_") + (B().s));
}
}  // namespace local_classes_2

namespace local_classes_3 {
static void run() {
  struct A {std::string s = "fa";}; struct B : A {B() {s += "b";}}; struct C : B {C() {s += "c";}}; show(std::string("local_classes3_") + (C().s));
}
}  // namespace local_classes_3

namespace local_classes_4 {
static void run() {
  struct A {virtual ~A() = default; virtual std::string m() {return "a";}}; struct B : A {std::string m() override {return "b";}}; struct C : B {std::string m() override {return "c" + B::m() + A::m();}}; C c; show(std::string("local_classes4_") + (c.m()));
}
}  // namespace local_classes_4

namespace local_classes_5 {
static const char * N = "global"; struct A {std::string s = "ga";};
static std::string f() {static const std::string N = "local"; struct B {std::string n() {return N;}}; return B().n();}
static std::string g() {struct A {std::string s = "la";}; struct B {A a; A make() {return A();}}; return B().a.s + B().make().s;}
static void run() {show(std::string("local_classes5_") + (f() + g()));}
}  // namespace local_classes_5

namespace local_classes_6 {
template <class T> std::string f() {struct L {static std::string n() {return T::name();} std::vector<T> v{T(), T()};}; return L::n() + std::to_string(L().v.size());}
struct X {static std::string name() {return "x";}}; struct Y {static std::string name() {return "y";}};
static void run() {show(std::string("local_classes6_") + (f<X>() + f<Y>()));}
}  // namespace local_classes_6

namespace local_classes_7 {
enum E {One = 10}; 
static void run() {enum E {One = 1, Two}; constexpr int K = 4; struct S {int a = Two; int n() {return One + K;}}; show(std::string("local_classes7_") + ("n" + std::to_string(S().a) + std::to_string(S().n())));}
}  // namespace local_classes_7

namespace local_classes_8 {
static int c() {static int n = 5; struct S {int next() {return ++n;}}; S s; s.next(); return S().next() + n;}
static void run() {show(std::string("local_classes8_") + ("n" + std::to_string(c())));}
}  // namespace local_classes_8

namespace local_classes_9 {
using A = std::vector<int>;
static void run() {using A = std::string; struct S {A a{"al"}; A f(A x) {return x + a;}}; show(std::string("local_classes9_") + (S().f("x")));}
}  // namespace local_classes_9

namespace local_classes_10 {
static void run() {
  std::string s; {struct A {std::string n = "a1";}; struct B : A {}; s += B().n;} {struct A {std::string n = "a2";}; struct B : A {}; s += B().n;} show(std::string("local_classes10_") + (s));
}
}  // namespace local_classes_10

namespace local_classes_11 {
static void run() {
  auto mk = [](int k) {struct A {int k; std::string n() {return std::to_string(k);}}; struct B : A {B(int k) : A{k * 2} {}}; return B(k);}; show(std::string("local_classes11_") + ("n" + mk(4).n()));
}
}  // namespace local_classes_11

namespace local_classes_12 {
static void run() {
  struct A {int v = 1; struct In {int w = 2;};}; struct B : A {In in; int sum() {return v + in.w;}}; show(std::string("local_classes12_") + ("n" + std::to_string(B().sum())));
}
}  // namespace local_classes_12

namespace local_classes_13 {
template <typename D> struct Crtp {std::string n() {return static_cast<D *>(this)->m();}};
static void run() {struct L : Crtp<L> {std::string m() {return "crtp";}}; show(std::string("local_classes13_") + (L().n()));}
}  // namespace local_classes_13

namespace local_classes_14 {
struct I {virtual ~I() = default; virtual std::string n() const = 0;};
static std::unique_ptr<I> mk(int k) {if (k) {struct A : I {std::string n() const override {return "A";}}; return std::make_unique<A>();} struct B : I {std::string n() const override {return "B";}}; struct C : B {std::string n() const override {return "C" + B::n();}}; return std::make_unique<C>();}
static void run() {show(std::string("local_classes14_") + (mk(1)->n() + mk(0)->n()));}
}  // namespace local_classes_14

static void run()
{
  local_classes_0::run();
  local_classes_1::run();
  local_classes_2::run();
  local_classes_3::run();
  local_classes_4::run();
  local_classes_5::run();
  local_classes_6::run();
  local_classes_7::run();
  local_classes_8::run();
  local_classes_9::run();
  local_classes_10::run();
  local_classes_11::run();
  local_classes_12::run();
  local_classes_13::run();
  local_classes_14::run();
}
