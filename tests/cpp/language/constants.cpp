// SPDX-License-Identifier: Apache-2.0

struct P { int x, y; int sum() const { return x + y; } };
void take(const P & p) {
  num("take", p.x);
  auto f = [&p] { return p.y; };
  num("takef", f());
  const P * pp = &p;
  num("takep", pp->y);
}
void outer(const int n) {
  auto f = [&n](int m) { return n * m; };
  num("outer", f(2));
  for (int i = 0; i < n; i += 3) num("oi", i);
}
int rec(const int n) { if (n == 0) return 0; const int r = rec(n - 1); return r + n; }
void swap_in(int & x) { const int old = x; x = 100; num("old", old); }
int by_const(const int & n) { int total = n; const int & alias = total; total += 5; return alias + n; }
struct S {
  int v = 2;
  int go() { const int before = v; v = 9; const int & after = v; v = 10; return before * 100 + after; }
  int peek() const { const auto & me = *this; return me.v; }
};

void run()
{
  const int k = 3;
  auto f = [&] { return k + 1; };
  num("a", f());
  const std::string cs = "b";
  auto g = [&cs] { return cs + "c"; };
  show(g());
  const auto & rs = cs;
  show("d" + rs);
  const int * pk = &k;
  num("e", *pk);
  for (const auto & [x, y] : std::map<std::string, int>{{"f", 1}, {"g", 2}}) {
    auto h = [&] { num(x, y); };
    h();
  }
  const std::function<int(int)> fact = [&](int n) { return n < 2 ? 1 : n * fact(n - 1); };
  num("h", fact(4));
  const std::vector<int> cv{1, 2};
  for (const auto & x : cv) num("i", x);
  num("j", cv[1] + cv.size());
  const P p{1, 2};
  num("k", p.sum());
  const P & rp = p;
  num("l", rp.x);
  take(p);
  P q = p;
  q.x = 9;
  num("m", p.x + q.x);
  std::vector<P> ps(2, p);
  ps[0].x = 50;
  num("n", ps[1].x + ps[0].x + p.x);
  const auto node2 = std::make_shared<P>(P{3, 4});
  node2->x = 7;
  num("o", node2->x);
  auto mod = [node2] { node2->x++; };
  mod();
  num("p", node2->x);
  int i = 0;
  const int & ci = i;
  i = 5;
  num("q", ci);
  auto l = [&ci] { return ci; };
  i = 6;
  num("r", l());
  const int before = i;
  i = 8;
  num("s", before);
  static const std::vector<std::string> names{"t", "u"};
  for (const auto & n : names) show(n);
  auto w = [] { return names.size(); };
  num("v", w());
  const bool flag = i > 3;
  if (flag) show("w");
  const char c = 'x';
  show(std::string(1, c));
  outer(4);
  num("y", rec(3));
  const auto [a1, b1] = std::make_pair(1, 2);
  auto z = [a1 = a1] { return a1; };
  num("z", z() + b1);
  swap_in(i);
  num("za", i);
  const int arr[] = {4, 5};
  num("zb", arr[1]);
  auto arrf = [&] { return arr[0]; };
  num("zc", arrf());
  const P ps2[] = {{1, 2}, {3, 4}};
  for (const auto & e : ps2) num("zd", e.sum());
  num("ze", by_const(2));
  std::string s1 = "zf";
  const std::string & s2 = s1;
  s1 += "q";
  show(s2);
  S s;
  num("zg", s.go());
  const S cs2;
  num("zh", cs2.peek());
}
