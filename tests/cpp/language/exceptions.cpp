// SPDX-License-Identifier: Apache-2.0

struct Mine : std::exception { int code = 7; };
void thrower(int n) {
  if (n == 1) throw std::runtime_error("one");
  if (n == 2) throw std::out_of_range("two");
  if (n == 3) throw 33;
  throw "text";
}
int safe(int d) {
  try {
    if (d == 0) throw std::domain_error("zero");
    return 12 / d;
  } catch (const std::domain_error &) { return -1; }
}
struct Guarded { explicit Guarded(bool fail) { if (fail) throw std::logic_error("bad"); } };
struct Fails { explicit Fails(int n) { if (n) throw std::runtime_error("f"); } };
struct Tried {
  Fails f;
  explicit Tried(int n) try : f(n) {} catch (const std::runtime_error &) { show("caught"); }
};
struct Raii {
  std::string n;
  explicit Raii(const std::string & s) : n(s) { show(n + "_open"); }
  ~Raii() { show(n + "_close"); }
};
void early(bool now) { Raii r(now ? "u" : "v"); if (now) return; show("w"); }

void run()
{
  try {
    thrower(1);
    show("no");
  }
  catch (const std::runtime_error & e) { show(std::string("a_") + e.what()); } catch (...) { show("no2"); }
  try { thrower(2); } catch (const std::exception & e) { show(std::string("b_") + e.what()); }
  try { thrower(4); } catch (...) { show("d"); }
  try {
    try { thrower(1); } catch (const std::runtime_error &) { show("e"); throw; }
  } catch (const std::exception & e) { show(std::string("f_") + e.what()); } num("g", safe(0));
  num("h", safe(3));
  try { Guarded g(true); } catch (const std::logic_error & e) { show("i"); }
  try { Mine m; throw m; } catch (const Mine & m) { num("j", m.code); }
  int x = 5;
  int y = x > 3 ? x : throw std::runtime_error("k");
  num("k", y);
  try {
    y = x < 3 ? x : throw std::runtime_error("l");
    show("no3");
  } catch (const std::runtime_error & e) { show(e.what()); }
  try { std::vector<int>{1}.at(5); show("no4"); } catch (const std::out_of_range &) { show("m"); }
  for (int i = 0; i < 3; ++i) {
    try { if (i == 1) throw i; num("n", i); } catch (int) { continue; }
    num("o", i);
  }
  try { Tried t(1); } catch (const std::runtime_error &) { show("p"); }
  { Raii r("q"); }  early(true);
  early(false);
  try { std::stoi("x"); show("no5"); } catch (const std::invalid_argument &) { show("t"); }
}
