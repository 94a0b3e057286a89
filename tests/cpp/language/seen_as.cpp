// SPDX-License-Identifier: Apache-2.0


namespace seen_as_0 {
struct A {std::string n() const {return "A";} virtual ~A() = default;}; struct B : A {std::string n() const {return "B";}};
struct H {
  std::shared_ptr<A> b = std::make_shared<B>(); A * raw = new B; std::vector<std::shared_ptr<A>> all{std::make_shared<B>()}; std::map<int, A *> by{{1, new B}};
  void go() {show("own0_" + this->b->n() + this->all[0]->n()); for (auto & e : this->all) {show("own1_" + e->n());} for (auto & [k, e] : by) {show("own2_" + e->n());} for (auto & p : by) {show("own3_" + p.second->n());}}
};
static void run() {
  H h; H * p = &h; h.go(); show("seen0_" + h.b->n() + h.raw->n() + (*h.raw).n() + h.all[0]->n() + p->b->n() + p->all.front()->n()); for (auto & e : h.all) {show("seen1_" + e->n());}
  std::map<std::string, std::shared_ptr<A>> m{{"x", std::make_shared<B>()}}; for (const auto & [k, e] : m) {show("seen3_" + k + e->n());} for (const auto & q : m) {show("seen4_" + q.first + q.second->n());}
  std::vector<std::pair<int, std::shared_ptr<B>>> v{{1, std::make_shared<B>()}}; for (auto & [k, e] : v) {show("seen5_" + e->n());} for (auto & q : v) {show("seen6_" + q.second->n());}
  std::map<int, std::map<int, B *>> mm{{1, {{2, new B}}}}; for (auto & [i, inner] : mm) {for (auto & [j, e] : inner) {show("seen7_" + e->n());}}
}
}  // namespace seen_as_0

static void run() {seen_as_0::run();}
