// SPDX-License-Identifier: Apache-2.0

namespace cast_0 {
struct B {std::string n = "b";}; struct D : B {std::string m;}; std::string f(const B & b) {return "B" + b.n;} std::string f(const D & d) {return "D" + f(static_cast<const B &>(d));}
static void run() {D d; show(std::string("cast0_") + (f(d)));}
}  // namespace cast_0

namespace cast_1 {
struct B {int v = 1;}; struct D : B {int w = 2;}; bool operator==(const B & a, const B & b) {return a.v == b.v;} bool operator==(const D & a, const D & b) {return static_cast<const B &>(a) == static_cast<const B &>(b) && a.w == b.w;}
static void run() {D a, b; show(std::string("cast1_") + (a == b ? "same" : "other"));}
}  // namespace cast_1

namespace cast_2 {
struct B {int v = 1; bool operator<(const B & o) const {return v < o.v;}}; struct D : B {int w = 2; bool operator<(const D & o) const {return static_cast<const B &>(*this) < static_cast<const B &>(o) || w < o.w;}};
static void run() {D a, b; b.w = 3; show(std::string("cast2_") + (a < b ? "less" : "not"));}
}  // namespace cast_2

namespace cast_3 {
struct B {std::string s; B & operator=(const B & o) {s = o.s + "_";  return *this;}}; struct D : B {std::string t; D & operator=(const D & o) {static_cast<B &>(*this) = o; t = o.t; return *this;}};
static void run() {D a, b; a.s = "x"; a.t = "y"; b = a; show(std::string("cast3_") + (b.s + b.t));}
}  // namespace cast_3

namespace cast_4 {
struct B {std::string s; B & operator+=(const B & o) {s += o.s; return *this;}}; struct D : B {D & operator+=(const D & o) {(B &)*this += (const B &)o; return *this;}};
static void run() {D a, b; a.s = "x"; b.s = "y"; b += a; show(std::string("cast4_") + (b.s));}
}  // namespace cast_4

namespace cast_5 {
struct B {std::string s = "b";}; struct D : B {std::string t; D & operator=(const D & o) {static_cast<B &>(*this) = o; t = o.t; return *this;}};
static void run() {D a, b; a.s = "x"; a.t = "y"; b = a; show(std::string("cast5_") + (b.s + b.t));}
}  // namespace cast_5

namespace cast_6 {
struct B {std::string s = "b"; friend std::ostream & operator<<(std::ostream & o, const B & b) {return o << b.s;}}; struct D : B {std::string t = "t"; friend std::ostream & operator<<(std::ostream & o, const D & d) {return o << dynamic_cast<const B &>(d) << d.t;} virtual ~D() = default;};
static void run() {std::ostringstream o; o << D(); show(std::string("cast6_") + (o.str()));}
}  // namespace cast_6

namespace cast_7 {
template<typename T> std::string to_s(const T & t) {std::ostringstream o; o << t; return o.str();} struct B {int i = 1;}; struct D : B {int j = 2;}; std::ostream & operator<<(std::ostream & o, const B & b) {return o << "B" << b.i;} std::ostream & operator<<(std::ostream & o, const D & d) {return o << "D" << static_cast<const B &>(d) << d.j;}
static void run() {show(std::string("cast7_") + (to_s(D())));}
}  // namespace cast_7

namespace cast_8 {
namespace io {struct Base {int i = 1;}; inline std::string str(const Base & b) {return "b" + std::to_string(b.i);}} struct D : io::Base {}; inline std::string str(const D & d) {return "d" + str(static_cast<const io::Base &>(d));}
static void run() {D d; show(std::string("cast8_") + (str(d)));}
}  // namespace cast_8

namespace cast_9 {
struct B {std::string operator()(int) const {return "b";} std::string operator[](int) const {return "i";}}; struct D : B {std::string operator()(int i) const {return "d" + static_cast<const B &>(*this)(i);} std::string operator[](int i) const {return "e" + static_cast<const B &>(*this)[i];}};
static void run() {D d; show(std::string("cast9_") + (d(1) + d[1]));}
}  // namespace cast_9

namespace cast_10 {
struct B {operator std::string() const {return "b";}}; struct D : B {operator std::string() const {return "d" + std::string(static_cast<const B &>(*this));}};
static void run() {D d; std::string s = d; show(std::string("cast10_") + (s));}
}  // namespace cast_10

namespace cast_11 {
struct A {std::string a = "a";}; struct B : A {std::string s = "b";}; struct D : B {std::string t; D & operator=(const B & o) {(B &)*this = o; t = "T"; return *this;}};
static void run() {D d; B b; b.s = "x"; b.a = "y"; d = b; show(std::string("cast11_") + (d.a + d.s + d.t));}
}  // namespace cast_11

namespace cast_12 {
struct Base { std::string name = "b"; };
struct Derived : Base { std::string more; };
static std::ostream & operator<<(std::ostream & os, const Base & arg) { os << arg.name; return os; }
static std::ostream & operator<<(std::ostream & os, const Derived & arg) { os << "d"; os << static_cast<const Base &>(arg); os << (const Base &)arg << (const Base &)(arg); os << arg.more; return os; }
static void run() {Derived d; d.more = "m"; std::ostringstream s; s << d; show(std::string("cast12_") + (s.str()));}
}  // namespace cast_12

namespace cast_13 {
struct Base { virtual ~Base() = default; };
struct Derived : Base {};
static std::string tell(const Base *) { return "b"; }
static std::string tell(const Derived * d) { return "d" + tell(static_cast<const Base *>(d)) + tell((Base *)d); }
struct Shower { std::string show(const Base &) { return "mb"; } std::string show(const Derived & d) { return "md" + show(static_cast<const Base &>(d)); } };
static void run() {Derived d; Shower s; show(std::string("cast13_") + (tell(&d) + s.show(d)));}
}  // namespace cast_13

static void run()
{
  cast_0::run();
  cast_1::run();
  cast_2::run();
  cast_3::run();
  cast_4::run();
  cast_5::run();
  cast_6::run();
  cast_7::run();
  cast_8::run();
  cast_9::run();
  cast_10::run();
  cast_11::run();
  cast_12::run();
  cast_13::run();
}
