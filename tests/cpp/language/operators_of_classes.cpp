// SPDX-License-Identifier: Apache-2.0


namespace operators_of_classes_0 {
struct V {int x, y; V operator+(const V & o) const {return {x + o.x, y + o.y};} V operator-() const {return {-x, -y};} bool operator==(const V & o) const {return x == o.x && y == o.y;} V & operator*=(int k) {x *= k; y *= k; return *this;}}; static V operator*(V v, int k) {return v *= k;} static V operator*(int k, const V & v) {return v * k;}
static void run() {V v = 2 * (V{1, 2} + V{3, 4}) * 3; V w = -v; show(std::string("operators_of_classes0_") + ("n" + std::to_string(v.x) + "_" + std::to_string(v.y) + (v == -w ? "eq" : "ne")));}
}  // namespace operators_of_classes_0

namespace operators_of_classes_1 {
struct C {std::string t; C & operator,(const std::string & s) {t += s; return *this;}}; 
static void run() {C c; c, std::string("a"), std::string("b"); int x = (1, 2, 3); for (int i = 0, j = 5; i < j; ++i, --j) x += j; show(std::string("operators_of_classes1_") + (c.t + std::to_string(x)));}
}  // namespace operators_of_classes_1

namespace operators_of_classes_2 {
struct Str {std::string s; Str & operator<<(const std::string & x) {s += x; return *this;} Str & operator<<(int n) {s += std::to_string(n); return *this;}}; static Str & operator>>(Str & a, std::string & out) {out = a.s; a.s.clear(); return a;}
static void run() {Str s; std::string o; s << "a" << 1 << std::string("b"); s >> o; show(std::string("operators_of_classes2_") + (o + std::to_string(s.s.size())));}
}  // namespace operators_of_classes_2

namespace operators_of_classes_3 {
namespace lib {struct T {std::string n;}; static std::string describe(const T & t) {return "lib" + t.n;} static std::ostream & operator<<(std::ostream & o, const T & t) {return o << "<" << t.n;}} 
static void run() {lib::T t{"x"}; std::ostringstream o; o << t; show(std::string("operators_of_classes3_") + (describe(t) + o.str().substr(1)));}
}  // namespace operators_of_classes_3

namespace operators_of_classes_4 {
struct E {std::map<std::string, std::string> m; std::string & operator[](const std::string & k) {return m[k];} const std::string & operator[](const std::string & k) const {static const std::string none = "none"; auto it = m.find(k); return it == m.end() ? none : it->second;}};
static void run() {E e; e["a"] = "v"; const E & c = e; show(std::string("operators_of_classes4_") + (e["a"] + c["zz"] + c["a"]));}
}  // namespace operators_of_classes_4

namespace operators_of_classes_5 {
struct Path {std::string p; Path operator/(const std::string & s) const {return {p + "_" + s};} operator const std::string &() const {return p;}};
static void run() {std::string s = Path{"a"} / "b" / "c"; show(std::string("operators_of_classes5_") + (s));}
}  // namespace operators_of_classes_5

namespace operators_of_classes_6 {
enum Dir {Up, Down}; static Dir & operator++(Dir & d) {d = d == Up ? Down : Up; return d;} static std::string nm(Dir d) {return d == Up ? "up" : "down";}
static void run() {Dir d = Up; ++d; std::string s = nm(d); ++d; show(std::string("operators_of_classes6_") + (s + nm(d)));}
}  // namespace operators_of_classes_6

namespace operators_of_classes_7 {
namespace lib {struct A {}; static std::string f(A) {return "adl";} static std::string g(int) {return "lg";}} static std::string f(int) {return "gl";}
static void run() {using namespace lib; show(std::string("operators_of_classes7_") + (f(lib::A()) + f(1) + g(2)));}
}  // namespace operators_of_classes_7

static void run()
{
  operators_of_classes_0::run();
  operators_of_classes_1::run();
  operators_of_classes_2::run();
  operators_of_classes_3::run();
  operators_of_classes_4::run();
  operators_of_classes_5::run();
  operators_of_classes_6::run();
  operators_of_classes_7::run();
}
