// SPDX-License-Identifier: Apache-2.0

int value = 1;
namespace deep {
  int value = 2;
  struct T {};
  int adl(T) { return 11; }
  int only() { return 12; }
  namespace er { int value2 = 3; }
}
namespace deep { namespace er { int value = 4; } }
namespace { int unnamed() { return 13; } }
int inc(int x) { return x + 1; }
int statics() { static int n = 0; return ++n; }
int later = 14;
int over(int) { return 1; }
int over(double) { return 2; }
int over(const char *) { return 3; }
int over(const std::string &) { return 4; }
int over(bool) { return 5; }
int dflt(int a = 1, int b = 2) { return a * 10 + b; }
constexpr int constexpr_fn(int n) { return n < 2 ? 1 : n * constexpr_fn(n - 1); }
std::vector<int> glob = {1, 2, 3};
struct Row { const char * s; int n; };
const Row table[] = {{"row", 1}, {"row2", 22}};
namespace inl { inline namespace v1 { int f() { return 15; } } }

void run()
{
  using namespace deep::er;
  num("a", value2);
  num("b", deep::value);
  num("c", ::value);
  namespace d = deep::er;
  num("d", d::value);
  using deep::only;
  num("e", only());
  int value = 99;
  num("f", value);
  num("g", ::value);
  num("h", adl(deep::T{}));
  num("i", unnamed());
  struct Local { int v; int twice() { return v * 2; } static int s() { return 5; } } l{4};
  num("j", l.twice());
  num("k", Local::s());
  enum Mode { OFF, ON = 3, AUTO };
  Mode m = AUTO;
  num("l", m);
  num("m", ON);
  typedef std::vector<int> Ints;
  Ints is{1, 2};
  num("n", is.size());
  using Fn = int (*)(int);
  Fn fn = inc;
  num("o", fn(1));
  num("p", statics() + statics() + statics());
  extern int later;
  num("q", later);
  auto f = [](int value) { return value; };
  num("r", f(2));
  for (int value = 0; value < 1; ++value) num("s", value);
  num("t", value);
  num("v", dflt() + dflt(5) + dflt(5, 6));
  const char * raw = R"(w)";
  show(raw);
  show("x" "y");
  num("z", constexpr_fn(4));
  num("za", glob.size());
  num("zb", table[1].n);
  show(table[0].s);
  num("zc", inl::v1::f() + inl::f());
  int arr[2][2] = {{1, 2}, {3, 4}};
  num("zd", arr[1][0]);
  num("ze", std::size(table));
  auto t = std::make_tuple(1, "zf", 2.5);
  show(std::get<1>(t));
  int ta;
  std::string tb;
  std::tie(ta, tb) = std::make_pair(5, std::string("zg"));
  num(tb, ta);
  std::optional<int> o;
  num("zh", o.has_value());
  o = 4;
  num("zi", *o + o.value_or(1));
  std::variant<int, std::string> va = std::string("zj");
  show(std::get<std::string>(va));
  std::array<int, 3> sa{4, 5};
  num("zl", sa[1] + sa[2] + sa.size());
  if (const auto it = std::find(is.begin(), is.end(), 2); it != is.end()) num("zm", *it);
}
