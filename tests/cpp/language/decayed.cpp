// SPDX-License-Identifier: Apache-2.0
// Pointers to characters that become strings, or that overloads and templates are asked with; arrays that are swapped; objects in raw memory.
#include <any>
#include <cstdio>
#include <cstring>
#include <deque>
#include <queue>
#include <set>
#include <string_view>
using namespace std::string_literals;
namespace d160
{
static void run()
{
char a[16] = "ab"; char b[16] = "cd"; std::swap(a, b); show(std::string("d160_") + (a)); show(std::string("d160_") + ("b"s + b));
}
}

namespace d42
{
static void run()
{
char a[16] = "x1"; std::vector<std::string> v(3); std::fill(v.begin(), v.begin() + 1, a); a[0] = 'y'; show(std::string("d42_") + (v[0]));
}
}

namespace d45
{
static void run()
{
char a[16] = "x1"; std::vector<std::string> v(3); std::fill_n(v.begin(), 2, a); std::generate(v.begin() + 2, v.end(), [&] {return a;}); a[0] = 'y'; for (auto & s : v) {show(std::string("d45_") + (s));}
}
}

namespace d48
{
static void run()
{
char a[16] = "x1"; std::vector<const char *> w{a, a + 1}; std::vector<std::string> v(w.begin(), w.end()); std::vector<std::string> u; u.assign(w.begin(), w.end()); u.insert(u.end(), w.begin(), w.end()); std::copy(w.begin(), w.begin() + 1, std::back_inserter(u)); a[0] = 'y'; a[1] = '2'; for (auto & s : v) {show(std::string("d48_") + (s));} for (auto & s : u) {show(std::string("d48_") + ("u" + s));} show(std::string("d48_") + ("w"s + w[0]));
}
}

namespace d414
{
static void run()
{
char a[16] = "x1"; std::string s; s = a; std::string t = std::move(s); std::optional<std::pair<std::string, int>> o = std::make_pair(a, 1); std::pair<std::string, std::string> p = {a, a}; p.first = a; a[0] = 'y'; show(std::string("d414_") + (t)); show(std::string("d414_") + (o->first + "o")); show(std::string("d414_") + (p.first + p.second));
}
}

namespace d426
{
static void run()
{
char a[16] = "x1"; std::tuple<std::string, std::string> t; std::get<0>(t) = a; std::tie(std::get<1>(t), std::ignore) = std::make_pair(a, 1); a[0] = 'y'; show(std::string("d426_") + (std::get<0>(t) + std::get<1>(t)));
}
}

namespace d427
{
static void run()
{
char a[16] = "ab"; char b[16] = "cd"; std::swap(a, b); show(std::string("d427_") + (a)); show(std::string("d427_") + ("b"s + b)); a[0] = 'x'; show(std::string("d427_") + (a)); show(std::string("d427_") + ("b"s + b));
}
}

namespace d428
{
struct P {char n[8] = "pp"; char m[2][8] = {"m0", "m1"};};
static void run()
{
P p, q; strcpy(q.n, "qq"); std::swap(p.n, q.n); std::swap(p.m[0], p.m[1]); show(std::string("d428_") + (p.n)); show(std::string("d428_") + (q.n + "q"s)); show(std::string("d428_") + (p.m[0])); show(std::string("d428_") + (p.m[1] + "1"s)); std::swap(p, q); show(std::string("d428_") + (p.n + "p"s));
}
}

namespace d429
{
static void run()
{
char a[16] = "x1"; std::string s = "o"; auto o = std::exchange(s, a); a[0] = 'y'; show(std::string("d429_") + (s)); show(std::string("d429_") + (o));
}
}

namespace d434
{
static void run()
{
char a[16] = "x1"; std::pair<const char *, int> q(a, 1); std::pair<std::string, int> p = q; a[0] = 'y'; show(std::string("d434_") + (p.first)); show(std::string("d434_") + (q.first));
}
}

namespace d435
{
static void run()
{
char a[16] = "x1"; auto t = std::make_tuple(a, 1); std::tuple<std::string, int> u = t; a[0] = 'y'; show(std::string("d435_") + (std::get<0>(u))); show(std::string("d435_") + (std::get<0>(t)));
}
}

namespace d436
{
static void run()
{
char a[16] = "x1"; std::vector<std::pair<std::string, int>> v; v.push_back(std::make_pair(a, 1)); std::map<std::string, std::string> m; m.insert(std::make_pair(a, a)); std::pair<std::string, int> p; p = std::make_pair(a, 2); a[0] = 'y'; show(std::string("d436_") + (v[0].first)); show(std::string("d436_") + (m.begin()->first + m.begin()->second)); show(std::string("d436_") + (p.first + "p"));
}
}

namespace d443
{
static void run()
{
char a[16] = "x1"; std::tuple<std::string, int> t; t = std::make_tuple(a, 1); std::pair<std::string, int> p; p = {a, 3}; std::pair<std::string, int> q{"z", 1}; std::swap(p, q); a[0] = 'y'; show(std::string("d443_") + (std::get<0>(t))); show(std::string("d443_") + (p.first + "p")); show(std::string("d443_") + (q.first + "q"));
}
}

namespace d51
{
std::string f(int) {return "int";} std::string f(const std::string & s) {return s;}
static void run()
{
char a[16] = "x1"; show(std::string("d51_") + (f(a))); show(std::string("d51_") + ("1"+f(a + 1))); show(std::string("d51_") + ("3" + f(&a[0])));
}
}

namespace d52
{
std::string f(int) {return "int";} std::string f(std::string_view s) {return std::string(s);}
static void run()
{
std::array<char, 8> a{}; strcpy(a.data(), "ar"); show(std::string("d52_") + (f(a.data()))); std::vector<char> v(8); strcpy(&v[0], "ve"); show(std::string("d52_") + (f(v.data())));
}
}

namespace d53
{
struct P {std::string s; P(const char * c) : s(c) {}}; struct Q {int i; Q(int i) : i(i) {}}; std::string f(const P & p) {return p.s;} std::string f(const Q &) {return "q";}
static void run()
{
char a[16] = "x1"; show(std::string("d53_") + (f(a)));
}
}

namespace d54
{
struct P {std::string s; P(const std::string & c) : s(c) {} P(int i) : s("int") {} P(const std::vector<std::string> &) : s("vec") {}};
static void run()
{
char a[16] = "x1"; P p(a); show(std::string("d54_") + (p.s)); P q{a}; show(std::string("d54_") + (q.s + "q")); P * r = new P(a); show(std::string("d54_") + (r->s + "r")); auto m = std::make_shared<P>(a); show(std::string("d54_") + (m->s + "m"));
}
}

namespace d55
{
struct N {std::string pre; N(const std::string & p) : pre(p) {} void add(const std::string & n) {show(pre + n);} void add(const std::string & n, int q) {show(pre + n + std::to_string(q));} template<typename T> void add(const std::string & n, T t, int) {show(pre + n + "t");}};
static void run()
{
N n("d55_"); char a[16] = "x1"; n.add(a); n.add(a, 4); n.add(a, "q", 1);
}
}

namespace d56
{
void put(std::string k, const std::string & v) {show(k + v);} void put(std::string k, int v) {show(k + "i" + std::to_string(v));} void put(std::string k, bool v) {show(k + (v ? "T" : "F"));} void put(std::string k, double v) {show(k + "d");}
static void run()
{
char a[16] = "x1"; put("d56_", std::string(a)); put(std::string("d56_") + "2", a); put(std::string("d56_") + a, 3);
}
}

namespace d510
{
template<typename It> std::string join(It b, It e) {std::string o; for (; b != e; ++b) o += *b; return o;} std::string join(const std::string & a, const std::string & b) {return a + "+" + b;}
static void run()
{
std::string s = "abc"; show(std::string("d510_") + (join(s.begin(), s.end()))); char a[8] = "xy", b[8] = "z"; show(std::string("d510_") + ("1" + join(a, a + 2)));
}
}

namespace d512
{
std::string f(unsigned char * p) {return "uc";} std::string f(char * p) {return "c";} std::string f(int * p) {return "i";}
static void run()
{
char a[16] = "x1"; unsigned char u[2] = {'a', 0}; int i[2] = {1, 2}; show(std::string("d512_") + (f(a))); show(std::string("d512_") + (f(u))); show(std::string("d512_") + (f(i))); show(std::string("d512_") + ("1" + f(&a[1])));
}
}

namespace d514
{
std::string f(char c) {return std::string("c") + c;} std::string f(const char * c) {return std::string("p") + c;}
static void run()
{
char a[16] = "xy"; show(std::string("d514_") + (f(a))); show(std::string("d514_") + (f(a[0]))); show(std::string("d514_") + (f(*a))); show(std::string("d514_") + (f(a + 1))); char c = 'q'; show(std::string("d514_") + (f(c))); show(std::string("d514_") + ("r" + f(&a[0])));
}
}

namespace d70
{
struct P {std::string n; P(const char * c) : n(c) {}};
static void run()
{
alignas(P) static char mem[sizeof(P)]; P * p = new (mem) P("pl"); show(std::string("d70_") + (p->n)); alignas(P) char m2[2 * sizeof(P)]; P * a = new (m2) P("a1"); P * b = new (m2 + sizeof(P)) P("b1"); show(std::string("d70_") + (a->n)); show(std::string("d70_") + (b->n));
}
}

namespace d71
{
struct P {std::string n; P(const char * c) : n(c) {}};
static void run()
{
alignas(P) static unsigned char mem[sizeof(P)]; P * p = new (mem) P("pl"); show(std::string("d71_") + (p->n)); alignas(P) uint8_t m2[sizeof(P)]; P * q = new (&m2) P("q"); show(std::string("d71_") + (q->n)); p->n += "x"; show(std::string("d71_") + (p->n));
}
}

namespace d73
{
struct P {std::string n; P(const char * c) : n(c) {}};
static void run()
{
P x("one"); x.~P(); P * q = new (&x) P("two"); show(std::string("d73_") + (x.n)); show(std::string("d73_") + (q->n + "q")); q->n = "z"; show(std::string("d73_") + (x.n));
}
}

namespace d75
{
struct S {int v; static void del(S * s) {show(std::string("d75_") + "sd" + std::to_string(s->v)); delete s;}}; void fd(S * s) {show(std::string("d75_") + "fd" + std::to_string(s->v));} struct F {void operator()(S * s) const {show(std::string("d75_") + "F" + std::to_string(s->v));}};
static void run()
{
{std::shared_ptr<S> p(new S{4}, S::del); show(std::string("d75_") + ("in"));} {std::shared_ptr<S> p(new S{5}, &S::del);} {std::shared_ptr<S> p(new S{6}, fd);} {std::unique_ptr<S, void (*)(S *)> p(new S{7}, fd);} {std::unique_ptr<S, F> p(new S{8});} {std::shared_ptr<S> p(new S{9}, F());} {std::unique_ptr<S, decltype(&fd)> p(new S{1}, &fd);} {std::shared_ptr<S> p; p.reset(new S{2}, fd);} {std::unique_ptr<S, std::function<void(S *)>> p(new S{3}, [](S * s) {fd(s);});}
}
}

static void run()
{
  d160::run();
  d42::run();
  d45::run();
  d48::run();
  d414::run();
  d426::run();
  d427::run();
  d428::run();
  d429::run();
  d434::run();
  d435::run();
  d436::run();
  d443::run();
  d51::run();
  d52::run();
  d53::run();
  d54::run();
  d55::run();
  d56::run();
  d510::run();
  d512::run();
  d514::run();
  d70::run();
  d71::run();
  d73::run();
  d75::run();
}
