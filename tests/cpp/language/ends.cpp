// SPDX-License-Identifier: Apache-2.0


namespace ends_0 {
struct S {std::string * o; std::string n; ~S() {*o += n;}};
struct H {S a, b; ~H() {*a.o += "H";}};
static void run() {std::string t; {H h{{&t, "a"}, {&t, "b"}};} show(std::string("ends0_") + (t));}
}  // namespace ends_0

namespace ends_1 {
static std::string lg;
struct S {std::string n; explicit S(std::string x) : n(std::move(x)) {} ~S() {lg += n;}};
struct B {S s{"B"}; ~B() {lg += "b";}}; struct D : B {S x{"x"}; S y{"y"}; ~D() {lg += "d";}};
static void run() {lg = ""; {D d;} show(std::string("ends1_") + (lg));}
}  // namespace ends_1

namespace ends_2 {
static std::string lg;
struct S {std::string n; ~S() {lg += n;}};
static void run() {lg = ""; {std::array<S, 2> a{S{"3"}, S{"4"}}; lg = "";} show(std::string("ends2_") + ("n" + lg));}
}  // namespace ends_2

namespace ends_3 {
struct G {std::function<void()> f; ~G() {f();}}; struct Two {G a; G b;};
static void run() {std::string t; {Two w{{[&t] {t += "a";}}, {[&t] {t += "b";}}}; t += "_";} show(std::string("ends3_") + (t));}
}  // namespace ends_3

namespace ends_4 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} S(S && s) : o(s.o), n(s.n) {s.o = nullptr;} ~S() {if (o) *o += n;}};
static void run() {std::string t; {std::vector<S> v; v.reserve(2); v.emplace_back(&t, "1"); v.emplace_back(&t, "2");} show(std::string("ends4_") + ("n" + t));}
}  // namespace ends_4

static void run()
{
  ends_0::run();
  ends_1::run();
  ends_2::run();
  ends_3::run();
  ends_4::run();
}
