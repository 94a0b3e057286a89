// SPDX-License-Identifier: Apache-2.0


namespace bases_0 {
struct L {std::string who = "L"; std::string l() const {return who;} L & set(std::string x) {who = x; return *this;}}; struct Rr {std::string who = "R"; std::string r() const {return who;} void add() {who += "P";}};
struct D : L, Rr {std::string both() {return L::who + Rr::who;}}; struct E : D {std::string who = "E"; std::string all() {return who + D::both() + L::who;}};
static std::string f(const Rr & r) {return r.who + r.r();}
static void run() {D d; d.add(); d.set("l"); E e; e.add(); Rr s = d; D c = d; c.add(); show(std::string("bases0_") + (d.both() + d.l() + d.r() + e.all() + s.who + c.both()));}
}  // namespace bases_0

namespace bases_1 {
struct Logger {std::string name_ = "log"; std::string ln() {return name_;}}; struct Named {std::string name_; explicit Named(std::string n) : name_(n) {} std::string nn() {return name_;}};
struct Node : public Logger, public Named {Node() : Named("node") {name2 = nn() + ln();} std::string name2;};
static void run() {Node n; show(std::string("bases1_") + (n.name2 + n.nn()));}
}  // namespace bases_1

namespace bases_2 {
struct A {std::string s; A(int n) : s("i" + std::to_string(n)) {} A(const char * c) : s(c) {} A(std::string a, std::string b = "_b") : s(a + b) {}};
struct B : A {using A::A; std::string t = s + "_t"; B(bool x) : A(x ? "yes" : "no") {}};
static void run() {show(std::string("bases2_") + (B(3).t + B("c").s + B(true).t + B(std::string("q"), "r").t));}
}  // namespace bases_2

namespace bases_3 {
struct L {std::string who = "L";}; struct Rr {std::string who = "R";};
struct D : L, Rr {std::string both() {return L::who + Rr::who;}};
static void run() {D d; L & l = d; Rr * r = &d; r->who = "r2"; l.who = "l2"; show(std::string("bases3_") + (d.both()));}
}  // namespace bases_3

namespace bases_4 {
struct A {std::string s = "a";}; struct B : A {std::string s = "b"; std::string both() {return A::s + s + this->A::s;}};
static void run() {B b; static_cast<A &>(b).s = "z"; show(std::string("bases4_") + (b.both() + b.A::s));}
}  // namespace bases_4

namespace bases_5 {
struct A {std::string s = "a";}; struct B : A {std::string s = "b";};
static std::string f(A & x) {return x.s;}
static std::string g(A * x) {return x->s;}
static void run() {B b; A & r = b; A * p = &b; show(std::string("bases5_") + (f(b) + g(&b) + r.s + p->s + b.s + static_cast<A &>(b).s + static_cast<A *>(&b)->s + (*p).s + b.A::s));}
}  // namespace bases_5

namespace bases_6 {
struct A {std::string n() {return "a";}}; struct B : A {std::string n() {return "b";}};
static void run() {B b; show(std::string("bases6_") + (static_cast<A &>(b).n() + static_cast<A *>(&b)->n() + b.n() + static_cast<A>(b).n()));}
}  // namespace bases_6

namespace bases_7 {
struct A {static const int k = 3; static constexpr const char * n = "an"; enum {Q = 5}; struct In {static std::string t() {return std::string(n) + std::to_string(k + Q);}};}; const int A::k;
static void run() {show(std::string("bases7_") + (A::In::t()));}
}  // namespace bases_7

static void run()
{
  bases_0::run();
  bases_1::run();
  bases_2::run();
  bases_3::run();
  bases_4::run();
  bases_5::run();
  bases_6::run();
  bases_7::run();
}
