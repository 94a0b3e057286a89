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

namespace ends_5 {
struct S {std::string * o; std::string n; ~S() {*o += n;}};
using Ref = S &;
struct H {Ref r; int k = 0;};
static void run() {
  std::string t; S s{&t, "a"}; {H h{s};} show(std::string("ends5_") + ("n" + t));
}
}  // namespace ends_5

namespace ends_6 {
struct S {std::string * o; std::string n; ~S() {*o += n;}};
template<typename T> struct H {using reference = T &; reference r; explicit H(reference x) : r(x) {}};
static void run() {
  std::string t; S s{&t, "a"}; {H<S> h(s);} show(std::string("ends6_") + ("n" + t));
}
}  // namespace ends_6

namespace ends_7 {
struct S {std::string * o; std::string n; ~S() {*o += n;}};
static void run() {
  std::string t; auto p = std::make_unique<S>(S{&t, "a"}); t = ""; p.reset(); show(std::string("ends7_") + ("n" + t));
}
}  // namespace ends_7

namespace ends_8 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; {auto p = std::make_unique<S>(&t, "a"); std::unique_ptr<S> q(new S(&t, "b"));} show(std::string("ends8_") + ("n" + t));
}
}  // namespace ends_8

namespace ends_9 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; auto p = std::make_unique<S>(&t, "a"); p = std::make_unique<S>(&t, "b"); t += "_"; p = nullptr; show(std::string("ends9_") + ("n" + t));
}
}  // namespace ends_9

namespace ends_10 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; {std::optional<S> p; p.emplace(&t, "a"); p.reset(); t += "_"; p.emplace(&t, "b");} show(std::string("ends10_") + ("n" + t));
}
}  // namespace ends_10

namespace ends_11 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; {std::vector<std::unique_ptr<S>> v; v.push_back(std::make_unique<S>(&t, "1")); v.push_back(std::make_unique<S>(&t, "2")); v.clear(); t += "_";} show(std::string("ends11_") + ("n" + t));
}
}  // namespace ends_11

namespace ends_12 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void take(std::unique_ptr<S> p) {*p->o += "t";}
static void run() {
  std::string t; auto p = std::make_unique<S>(&t, "1"); take(std::move(p)); t += "_"; show(std::string("ends12_") + ("n" + t));
}
}  // namespace ends_12

namespace ends_13 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
struct H {std::unique_ptr<S> p; std::string t;};
static void run() {
  std::string t; std::vector<H> v; {H h{std::make_unique<S>(&t, "a"), "x"}; v.push_back(std::move(h)); t += "1";} t += "2"; v.clear(); show(std::string("ends13_") + ("n" + t));
}
}  // namespace ends_13

namespace ends_14 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
struct H {std::unique_ptr<S> p;};
static H make(std::string * t) {H h; h.p = std::make_unique<S>(t, "m"); return h;}
static void run() {
  std::string t; {auto h = make(&t); t += "1"; H k; k = std::move(h); t += "2";} show(std::string("ends14_") + ("n" + t));
}
}  // namespace ends_14

namespace ends_15 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
class Holder {std::unique_ptr<S> p_; public: explicit Holder(std::unique_ptr<S> p) : p_(std::move(p)) {} S & get() {return *p_;}};
static std::unique_ptr<S> mk(std::string * t, bool b) {auto p = std::make_unique<S>(t, "k"); if (b) {return p;} return nullptr;}
static void run() {
  std::string t; {Holder h(mk(&t, true)); h.get().n += "z"; t += "1"; mk(&t, false); } show(std::string("ends15_") + ("n" + t));
}
}  // namespace ends_15

namespace ends_16 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} virtual ~S() {*o += n;}};
struct D : S {using S::S; ~D() override {*o += "D";}};
static void share(std::shared_ptr<S> p, std::vector<std::shared_ptr<S>> & v) {v.push_back(p);}
static void run() {
  std::string t; std::vector<std::shared_ptr<S>> v; share(std::make_unique<D>(&t, "a"), v); t += "1"; std::unique_ptr<S> q = std::make_unique<D>(&t, "b"); std::unique_ptr<S> r = std::move(q); t += "2"; r.reset(); show(std::string("ends16_") + ("n" + t));
}
}  // namespace ends_16

namespace ends_17 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; std::map<std::string, std::unique_ptr<S>> m; m["a"] = std::make_unique<S>(&t, "a"); m.emplace("b", std::make_unique<S>(&t, "b")); m["a"] = nullptr; t += "1"; auto p = std::move(m["b"]); m.clear(); t += "2"; S * raw = p.release(); t += "3"; delete raw; show(std::string("ends17_") + ("n" + t));
}
}  // namespace ends_17

namespace ends_18 {
struct S {std::string n;}; struct H {S & r; std::string tag;};
static void run() {
  S a{"a"}, b{"b"}; H arr[] = {{a, "1"}, {b, "2"}}; a.n = "z"; show(std::string("ends18_") + (arr[0].r.n + arr[1].r.n));
}
}  // namespace ends_18

namespace ends_19 {
struct S {std::string n;}; struct H {std::string tag; std::shared_ptr<S> & p;};
static void run() {
  std::shared_ptr<S> p; H hs[] = {{"x", p}}; for (auto & h : hs) h.p = std::make_shared<S>(S{"made"}); show(std::string("ends19_") + (p ? p->n : "none"));
}
}  // namespace ends_19

namespace ends_20 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static size_t length(const std::unique_ptr<S> & p) {return p->n.size();}
static size_t moved(std::unique_ptr<S> && p) {return p->n.size();}
static void run() {
  std::string t; auto p = std::make_unique<S>(&t, "a"); auto f = [](const std::unique_ptr<S> & q) {return q->n;};
  length(p); f(p); moved(std::move(p)); show(std::string("ends20_") + ("n" + t));
}
}  // namespace ends_20

namespace ends_21 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
static void run() {
  std::string t; std::vector<std::unique_ptr<S>> v, w, x; v.push_back(std::make_unique<S>(&t, "a")); v.push_back(std::make_unique<S>(&t, "b"));
  std::move(v.begin(), v.end(), std::back_inserter(w)); v.clear(); t += "1";
  x.insert(x.end(), std::make_move_iterator(w.begin()), std::make_move_iterator(w.end())); w.clear(); t += "2"; show(std::string("ends21_") + (t + x[0]->n));
}
}  // namespace ends_21

namespace ends_22 {
struct S {std::string * o; std::string n; S(std::string * x, std::string y) : o(x), n(y) {} ~S() {*o += n;}};
struct Keep {void operator()(S *) const {}};
static void run() {
  std::string t; S s(&t, "a"); {std::unique_ptr<S, Keep> p(&s); p->n += "b";} show(std::string("ends22_") + ("n" + t));
}
}  // namespace ends_22

static void run()
{
  ends_0::run();
  ends_1::run();
  ends_2::run();
  ends_3::run();
  ends_4::run();
  ends_5::run();
  ends_6::run();
  ends_7::run();
  ends_8::run();
  ends_9::run();
  ends_10::run();
  ends_11::run();
  ends_12::run();
  ends_13::run();
  ends_14::run();
  ends_15::run();
  ends_16::run();
  ends_17::run();
  ends_18::run();
  ends_19::run();
  ends_20::run();
  ends_21::run();
  ends_22::run();
}
