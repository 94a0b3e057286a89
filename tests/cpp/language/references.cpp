// SPDX-License-Identifier: Apache-2.0

struct P { int x; int y; };
void bump(int & x) { x += 10; }
void bump_ptr(int * x) { *x += 100; }
void append(std::string & s) { s.append("z"); }
void set_first(int * a) { a[0] = 55; }
void change(P & p) { p.x = 60; }
void by_value(P p) { p.x = 61; }
int & pick(int & a, int & b, bool first) { return first ? a : b; }

void run()
{
  int a = 1;
  int & r = a;
  r = 5;
  num("a", a);
  auto & r2 = r;
  r2++;
  num("b", a);
  auto copy = r;
  copy = 9;
  num("c", a);
  const int & cr = a;
  a = 7;
  num("d", cr);
  bump(a);
  num("e", a);
  bump_ptr(&a);
  num("f", a);
  int * p = &a;
  *p = 3;
  num("g", a);
  (*p)++;
  num("h", a);
  int ** pp = &p;
  **pp = 20;
  num("i", a);
  int b = 50;
  p = &b;
  *p += 1;
  num("j", a + b);
  *pp = &a;
  *p = 2;
  num("k", a);
  std::string s = "x";
  std::string & rs = s;
  rs += "y";
  show(s);
  append(s);
  show("l" + s);
  std::string t = s;
  t += "t";
  show("m" + s);
  auto * ps = &s;
  ps->append("p");
  show("n" + s);
  std::vector<int> v{1, 2, 3};
  for (auto & x : v) x *= 2;
  num("o", v[0] + v[1] + v[2]);
  for (auto x : v) x = 0;
  num("p", v[0]);
  auto & e = v[1];
  e = 100;
  num("q", v[1]);
  auto w = v;
  w[0] = 77;
  num("r", v[0]);
  std::vector<int> & rv = v;
  rv.push_back(5);
  num("s", v.size());
  std::swap(a, b);
  num("t", a);
  num("u", b);
  int arr[3] = {1, 2, 3};
  int * q = arr;
  q[1] = 9;
  num("v", arr[1]);
  ++q;
  num("w", *q);
  num("x", *(q + 1));
  set_first(arr);
  num("y", arr[0]);
  int & m = pick(a, b, true);
  m = 123;
  num("z", a);
  pick(a, b, false) = 321;
  num("za", b);
  std::pair<int, std::string> pr{1, "k"};
  auto & [n, st] = pr;
  n = 4;
  st += "z";
  num("zb", pr.first);
  show("zc" + pr.second);
  auto [n2, st2] = pr;
  n2 = 8;
  num("zd", pr.first);
  P pt{1, 2};
  auto & [px, py] = pt;
  px = 6;
  num("ze", pt.x + py);
  P pc = pt;
  pc.x = 0;
  num("zf", pt.x);
  P & pr2 = pt;
  pr2.y = 40;
  num("zg", pt.y);
  P * ptr = &pt;
  ptr->x = 8;
  num("zh", pt.x);
  change(pt);
  num("zi", pt.x);
  by_value(pt);
  num("zj", pt.x);
  (a > 0 ? a : b) = 5;
  num("zk", a);
  std::map<std::string, int> mm;
  mm["a"] = 1;
  mm["a"]++;
  mm["b"] += 5;
  for (auto & [k, val] : mm) val += 10;
  num("zl", mm["a"] + mm["b"]);
  int & in = mm["c"];
  in = 3;
  num("zm", mm.at("c"));
  auto it = mm.find("a");
  it->second = 99;
  num("zn", mm["a"]);
}
