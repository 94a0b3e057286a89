// SPDX-License-Identifier: Apache-2.0


namespace categories_0 {
struct P {}; 
static std::string f(const P &) {return "c";}
static std::string f(P &) {return "l";}
static std::string f(P &&) {return "r";}
static void run() {P p; const P c; P & r = p; const P & q = p; show(std::string("categories0_") + (f(p) + f(c) + f(r) + f(q) + f(P()) + f(std::move(p)) + f(static_cast<P &&>(p)) + f(std::as_const(p))));}
}  // namespace categories_0

namespace categories_1 {
struct V {std::string v = "v"; const std::string & get() const {static std::string k = "const"; return k;} std::string & get() {return v;}};
static void run() {V v; const V & c = v; show(std::string("categories1_") + (v.get() + c.get() + std::as_const(v).get()));}
}  // namespace categories_1

namespace categories_2 {
struct M {std::map<std::string, std::string> m; void set(std::string k, const std::string & v) {m[k] = "L" + v;} void set(std::string k, std::string && v) {m[k] = "R" + v;}};
static void run() {M m; std::string v = "v"; m.set("a", v); m.set("b", "lit"); m.set("c", std::move(v)); show(std::string("categories2_") + (m.m["a"] + m.m["b"] + m.m["c"]));}
}  // namespace categories_2

static void run()
{
  categories_0::run();
  categories_1::run();
  categories_2::run();
}
