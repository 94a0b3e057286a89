// SPDX-License-Identifier: Apache-2.0

static void copies_0() {
  std::vector<int> v{1}; std::vector<int> w(std::move(v)); v = {9}; show(std::string("c0_") + ("n" + std::to_string(w[0])));
}
static void copies_1() {
  std::vector<int> v{1}; std::vector<int> w = std::move(v); v = {9}; show(std::string("c1_") + ("n" + std::to_string(w[0])));
}
static void copies_2() {
  struct S {std::vector<int> v; explicit S(std::vector<int> x) : v(std::move(x)) {}}; std::vector<int> a{1}; S s(std::move(a)); a = {5}; show(std::string("c2_") + ("n" + std::to_string(s.v[0])));
}
static void copies_3() {
  struct S {int n = 1;}; S a; S b(std::move(a)); a.n = 7; show(std::string("c3_") + ("n" + std::to_string(b.n)));
}
static void copies_4() {
  struct S {int n = 1;}; S a; S b{std::move(a)}; a.n = 7; show(std::string("c4_") + ("n" + std::to_string(b.n)));
}
static void copies_5() {
  struct S {int n = 1;}; S a; std::vector<S> v; v.push_back(std::move(a)); a.n = 7; show(std::string("c5_") + ("n" + std::to_string(v[0].n)));
}
static void copies_6() {
  struct S {int n = 1;}; S a; auto p = std::make_shared<S>(std::move(a)); a.n = 7; show(std::string("c6_") + ("n" + std::to_string(p->n)));
}
static void copies_7() {
  struct S {int n = 1;}; S a; std::optional<S> o(std::move(a)); a.n = 7; show(std::string("c7_") + ("n" + std::to_string(o->n)));
}
static void copies_8() {
  struct S {int n = 1;}; S a; auto f = [b = std::move(a)] {return b.n;}; a.n = 7; show(std::string("c8_") + ("n" + std::to_string(f())));
}
static void copies_9() {
  struct S {int n = 1;}; S a; std::map<int, S> m; m.emplace(1, std::move(a)); a.n = 7; show(std::string("c9_") + ("n" + std::to_string(m[1].n)));
}
static void copies_10() {
  struct S {int n = 1;}; S a; std::pair<int, S> p(1, std::move(a)); a.n = 7; show(std::string("c10_") + ("n" + std::to_string(p.second.n)));
}
static void copies_11() {
  struct S {int n = 1;}; struct H {S s; explicit H(S x) : s(std::move(x)) {}}; S a; H h(a); a.n = 7; show(std::string("c11_") + ("n" + std::to_string(h.s.n)));
}
static void copies_12() {
  struct S {int n = 1;}; struct H {S s; explicit H(S && x) : s(std::move(x)) {}}; S a; H h(std::move(a)); a.n = 7; show(std::string("c12_") + ("n" + std::to_string(h.s.n)));
}
static void copies_13() {
  struct S {int n = 1;}; struct H {S s; explicit H(S && x) : s(std::forward<S>(x)) {}}; S a; H h(std::move(a)); a.n = 7; show(std::string("c13_") + ("n" + std::to_string(h.s.n)));
}
static void copies_14() {
  struct S {int n = 1;}; S a; S b = static_cast<S &&>(a); a.n = 7; show(std::string("c14_") + ("n" + std::to_string(b.n)));
}
static void copies_15() {
  struct S {int n = 1;}; struct H {S s;}; S a; H h{std::move(a)}; a.n = 7; show(std::string("c15_") + ("n" + std::to_string(h.s.n)));
}
static void copies_16() {
  struct S {int n = 1;}; auto id = [](S & s) -> S & {return s;}; S a; S b(id(a)); a.n = 7; show(std::string("c16_") + ("n" + std::to_string(b.n)));
}
static void copies_17() {
  struct S {int n = 1;}; S a; S & r = a; S b(r); a.n = 7; show(std::string("c17_") + ("n" + std::to_string(b.n)));
}
static void copies_18() {
  struct S {int n = 1; S & self() {return *this;}}; S a; S b(a.self()); a.n = 7; show(std::string("c18_") + ("n" + std::to_string(b.n)));
}
static void copies_19() {
  struct S {int n = 1;}; std::vector<S> v(1); S b(v.at(0)); v[0].n = 7; show(std::string("c19_") + ("n" + std::to_string(b.n)));
}
static void copies_20() {
  struct S {int n = 1;}; std::vector<S> v(1); S b(v.front()); v[0].n = 7; show(std::string("c20_") + ("n" + std::to_string(b.n)));
}
static void copies_21() {
  struct S {int n = 1;}; std::map<int, S> m{{1, S{}}}; S b(m.at(1)); m[1].n = 7; show(std::string("c21_") + ("n" + std::to_string(b.n)));
}
static void copies_22() {
  struct S {int n = 1;}; auto p = std::make_shared<S>(); S b(*p); p->n = 7; show(std::string("c22_") + ("n" + std::to_string(b.n)));
}
static void copies_23() {
  struct S {int n = 1;}; std::optional<S> o{S{}}; S b(o.value()); o->n = 7; show(std::string("c23_") + ("n" + std::to_string(b.n)));
}
static void copies_24() {
  std::vector<int> v{1}; std::vector<int> w{v}; v[0] = 7; show(std::string("c24_") + ("n" + std::to_string(w[0])));
}
static void copies_25() {
  std::vector<int> v{1}; std::vector<int> w(std::ref(v).get()); v[0] = 7; show(std::string("c25_") + ("n" + std::to_string(w[0])));
}
static void copies_26() {
  std::vector<int> v{1}; std::vector<int> w(std::as_const(v)); v[0] = 7; show(std::string("c26_") + ("n" + std::to_string(w[0])));
}
static void run() {
  copies_0();
  copies_1();
  copies_2();
  copies_3();
  copies_4();
  copies_5();
  copies_6();
  copies_7();
  copies_8();
  copies_9();
  copies_10();
  copies_11();
  copies_12();
  copies_13();
  copies_14();
  copies_15();
  copies_16();
  copies_17();
  copies_18();
  copies_19();
  copies_20();
  copies_21();
  copies_22();
  copies_23();
  copies_24();
  copies_25();
  copies_26();
}
