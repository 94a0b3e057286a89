// SPDX-License-Identifier: Apache-2.0

static void moves_and_streams_0() {
  std::istringstream i("1,2"); int a, b; i >> a; i.ignore(); i >> b; show(std::string("m0_") + ("n" + std::to_string(a + b)));
}
static void moves_and_streams_1() {
  std::istringstream i("ab;cd"); i.ignore(10, ';'); std::string t; i >> t; show(std::string("m1_") + (t));
}
static void moves_and_streams_2() {
  std::istringstream i("ab cd"); std::string t; i >> t; i.seekg(0); i >> t; show(std::string("m2_") + (t));
}
static void moves_and_streams_3() {
  std::istringstream i("abcd"); i.seekg(2); std::string t; i >> t; show(std::string("m3_") + (t));
}
static void moves_and_streams_4() {
  std::stringstream o; o << "abc"; o.seekp(0); o << "Z"; show(std::string("m4_") + (o.str()));
}
static void moves_and_streams_5() {
  std::ostringstream o; o << "abc"; o.str(""); o.clear(); o << "z"; show(std::string("m5_") + (o.str()));
}
static void moves_and_streams_6() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) {n = o.n; o.n = -1;}}; S a(3); S b(std::move(a)); show(std::string("m6_") + ("n" + std::to_string(b.n) + (a.n < 0 ? "m" : "k")));
}
static void moves_and_streams_7() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;} S(const S &) = default;}; S a(3); S b = a; show(std::string("m7_") + ("n" + std::to_string(b.n) + (a.n < 0 ? "m" : "k")));
}
static void moves_and_streams_8() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; auto mk = [](int x) {S s(x); return s;}; S b = mk(4); show(std::string("m8_") + ("n" + std::to_string(b.n)));
}
static void moves_and_streams_9() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;} S & operator=(S && o) {n = o.n + 1; return *this;}}; std::vector<S> v; v.push_back(S(5)); v.emplace_back(6); show(std::string("m9_") + ("n" + std::to_string(v[0].n) + std::to_string(v[1].n)));
}
static void moves_and_streams_10() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; std::map<int, S> m; m.emplace(1, S(7)); show(std::string("m10_") + ("n" + std::to_string(m.at(1).n)));
}
static void moves_and_streams_11() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; S a(3); auto f = [](S s) {return s.n;}; int r = f(std::move(a)); show(std::string("m11_") + ("n" + std::to_string(r) + (a.n < 0 ? "m" : "k")));
}
static void moves_and_streams_12() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; std::optional<S> o; o.emplace(8); show(std::string("m12_") + ("n" + std::to_string(o->n)));
}
static void moves_and_streams_13() {
  struct S {std::unique_ptr<int> p; S(int x) : p(new int(x)) {} S(S && o) : p(std::move(o.p)) {}}; S a(3); S b(std::move(a)); show(std::string("m13_") + ("n" + std::to_string(*b.p)));
}
static void moves_and_streams_14() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; struct H {S s; explicit H(S x) : s(std::move(x)) {}}; H h(S(9)); show(std::string("m14_") + ("n" + std::to_string(h.s.n)));
}
static void moves_and_streams_15() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; S a(3); auto f = [s = std::move(a)]() {return s.n;}; show(std::string("m15_") + ("n" + std::to_string(f()) + (a.n < 0 ? "m" : "k")));
}
static void moves_and_streams_16() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; S a(3); std::pair<int, S> p(1, std::move(a)); show(std::string("m16_") + ("n" + std::to_string(p.second.n)));
}
static void moves_and_streams_17() {
  struct S {int n = 0; S(int x) : n(x) {} S(S && o) : n(o.n) {o.n = -1;}}; auto p = std::make_unique<S>(S(4)); show(std::string("m17_") + ("n" + std::to_string(p->n)));
}
static void moves_and_streams_18() {
  int a[] = {3, 2, 1}; std::sort(a, a + 3); show(std::string("m18_") + ("n" + std::to_string(a[0])));
}
static void run() {
  moves_and_streams_0();
  moves_and_streams_1();
  moves_and_streams_2();
  moves_and_streams_3();
  moves_and_streams_4();
  moves_and_streams_5();
  moves_and_streams_6();
  moves_and_streams_7();
  moves_and_streams_8();
  moves_and_streams_9();
  moves_and_streams_10();
  moves_and_streams_11();
  moves_and_streams_12();
  moves_and_streams_13();
  moves_and_streams_14();
  moves_and_streams_15();
  moves_and_streams_16();
  moves_and_streams_17();
  moves_and_streams_18();
}
