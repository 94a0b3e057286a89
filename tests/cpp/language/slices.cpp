// SPDX-License-Identifier: Apache-2.0


namespace slices_0 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static std::string f(A a) {return a.n();}
static std::string g(const A & a) {return a.n();}
static A h(const B & b) {return b;}
static void run() {B b; A a = b; A c(b); A d{b}; std::vector<A> v; v.push_back(b); v.emplace_back(b); std::vector<A> w{b, B()}; std::array<A, 1> q{b}; show(std::string("slices0_") + (a.n() + c.n() + d.n() + f(b) + g(b) + h(b).n() + v[0].n() + v[1].n() + w[0].n() + w[1].n() + q[0].n()));}
}  // namespace slices_0

namespace slices_1 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static void run() {B b; A a; a = b; std::map<int, A> m; m[1] = b; m.emplace(2, b); m.insert({3, b}); std::optional<A> o = b; std::pair<int, A> p{1, b}; std::tuple<A> t{b}; show(std::string("slices1_") + (a.n() + m[1].n() + m.at(2).n() + m.at(3).n() + o->n() + p.second.n() + std::get<0>(t).n()));}
}  // namespace slices_1

namespace slices_2 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static void run() {B b; auto f = [a = A(b)] {return a.n();}; std::function<std::string(A)> g = [](A a) {return a.n();}; auto p = std::make_shared<A>(b); A & r = b; A c = r; auto d = r; A * q = &b; A e = *q; show(std::string("slices2_") + (f() + g(b) + p->n() + c.n() + d.n() + e.n() + r.n() + q->n()));}
}  // namespace slices_2

namespace slices_3 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}}; struct H {A a; H(const B & b) : a(b) {} H(A x, int) : a(x) {}};
static void run() {B b; show(std::string("slices3_") + (H(b).a.n() + H(b, 1).a.n()));}
}  // namespace slices_3

namespace slices_4 {
struct A {std::string s; A(std::string x) : s(x) {} A(const A & o) : s(o.s + "c") {} virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() : A("B") {} std::string n() const override {return "over";}};
static std::string f(A a) {return a.n();}
static void run() {B b; A a = b; std::vector<A> v; v.reserve(4); v.push_back(b); show(std::string("slices4_") + (a.n() + "_" + f(b) + "_" + v[0].n()));}
}  // namespace slices_4

namespace slices_5 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static std::string f() {try {throw B();} catch (A a) {return a.n();}}
static std::string g() {try {throw B();} catch (A & a) {return a.n();}}
static std::string h() {try {try {throw B();} catch (A & a) {throw;}} catch (A & a) {return a.n();}}
static std::string i() {try {try {throw B();} catch (A & a) {throw a;}} catch (A & a) {return a.n();}}
static void run() {show(std::string("slices5_") + (f() + g() + h() + i()));}
}  // namespace slices_5

namespace slices_6 {
struct M : std_msgs::msg::String {std::string extra = "x"; std::string n() const {return data + extra;}};
static void run() {M m; m.data = "d"; std_msgs::msg::String s = m; s.data += "2"; show(std::string("slices6_") + (s.data + m.data + m.n()));}
}  // namespace slices_6

namespace slices_7 {
struct A {int k = 1; A clone() const {return *this;} virtual int v() const {return k;} virtual ~A() = default;}; struct B : A {int v() const override {return 9;}};
static A mk(bool b) {if (b) return B(); return A();}
static void run() {B b; b.k = 4; A x = true ? static_cast<A>(b) : A(); A ar[2] = {b, b}; ar[1].k = 7; for (A a : ar) a.k = 0; std::string t; for (auto a : {static_cast<A>(b)}) t += std::to_string(a.v()); show(std::string("slices7_") + ("n" + std::to_string(b.clone().v()) + std::to_string(mk(true).v()) + std::to_string(x.v()) + std::to_string(ar[1].v()) + t));}
}  // namespace slices_7

namespace slices_8 {
static void run() {
  struct A {std::string s = "a"; A() = default; A(const A & o) : s(o.s + "c") {}}; struct B : A {int k = 1;}; B b; b.k = 5; B d = b; B e(d); std::vector<B> v{b}; show(std::string("slices8_") + (d.s + std::to_string(d.k) + e.s + std::to_string(v[0].k)));
}
}  // namespace slices_8

namespace slices_9 {
static void run() {
  struct A {std::string s = "a"; A & operator=(const A & o) {s = o.s + "q"; return *this;}}; struct B : A {int k = 1;}; B b, c; b.k = 5; b.s = "z"; c = b; show(std::string("slices9_") + (c.s + std::to_string(c.k)));
}
}  // namespace slices_9

namespace slices_10 {
static void run() {
  struct A {std::string s = "a"; A() = default; A(const A & o) : s(o.s + "c") {}}; struct H {A a; int k = 2;}; H h; h.k = 3; H g = h; show(std::string("slices10_") + (g.a.s + std::to_string(g.k)));
}
}  // namespace slices_10

namespace slices_11 {
static void run() {
  struct A {std::string s = "a"; A & operator=(const A & o) {s = o.s + "q"; return *this;}}; struct H {A a; int k = 2;}; H h, g; h.k = 3; g = h; show(std::string("slices11_") + (g.a.s + std::to_string(g.k)));
}
}  // namespace slices_11

namespace slices_12 {
static void run() {
  struct A {std::string s = "a"; A & operator=(const A & o) {s = o.s + "q"; return *this;}}; std::vector<A> v(2); v[0] = A(); std::map<int, A> m; m[1] = A(); std::pair<A, int> p, q; p = q; show(std::string("slices12_") + (v[0].s + m[1].s + p.first.s));
}
}  // namespace slices_12

namespace slices_13 {
static void run() {
  struct A {std::string s; A(const std::string & x) : s(x) {} A & operator=(const std::string & x) {s = x + "="; return *this;}}; struct B : A {using A::A; using A::operator=; int k = 1;}; B b("i"), c("j"); b = std::string("str"); c.k = 4; b = c; show(std::string("slices13_") + (b.s + std::to_string(b.k)));
}
}  // namespace slices_13

namespace slices_14 {
static void run() {
  struct A {static int & n() {static int k = 0; return k;} A() {++n();} A(const A &) {n() += 10;} ~A() {}}; struct B : A {}; B b; B c = b; auto f = [](B x) {}; f(b); show(std::string("slices14_") + ("n" + std::to_string(A::n())));
}
}  // namespace slices_14

namespace slices_15 {
static void run() {
  struct A {std::string s = "a"; A() = default; A(const A & o) : s(o.s + "c") {}}; struct B : virtual A {}; struct C : virtual A {}; struct D : B, C {int k = 3;}; D d; D e = d; show(std::string("slices15_") + (e.s + std::to_string(e.k)));
}
}  // namespace slices_15

namespace slices_16 {
static void run() {
  struct A {std::string s = "a"; A() = default; A(A && o) : s(o.s + "m") {o.s = "gone";} A(const A & o) : s(o.s + "c") {}}; struct B : A {B() = default; B(B &&) = default; B(const B &) = default;}; B b; B c = b; show(std::string("slices16_") + (c.s));
}
}  // namespace slices_16

namespace slices_17 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static std::string f(A a) {return a.n();}
static void run() {
  B b; A * p = &b; auto x = *p; show(std::string("slices17_") + (x.n() + f(*p)));
}
}  // namespace slices_17

namespace slices_18 {
struct A {std::string s = "A"; virtual std::string n() const {return s;} virtual ~A() = default;}; struct B : A {B() {s = "B";} std::string n() const override {return "over";}};
static auto g(const A & a) {auto c = a; return c.n();}
static void run() {
  B b; std::unique_ptr<A> p = std::make_unique<B>(); auto x = *p; auto f = [c = *p] {return c.n();}; show(std::string("slices18_") + (x.n() + g(b) + g(*p) + f()));
}
}  // namespace slices_18

static void run()
{
  slices_0::run();
  slices_1::run();
  slices_2::run();
  slices_3::run();
  slices_4::run();
  slices_5::run();
  slices_6::run();
  slices_7::run();
  slices_8::run();
  slices_9::run();
  slices_10::run();
  slices_11::run();
  slices_12::run();
  slices_13::run();
  slices_14::run();
  slices_15::run();
  slices_16::run();
  slices_17::run();
  slices_18::run();
}
