// SPDX-License-Identifier: Apache-2.0

struct S {
  int v = 1;
  int go() {
    auto f = [this] { v += 2; return v; };
    auto g = [*this]() mutable { v = 100; return v; };
    auto h = [&] { v++; };
    h();
    return f() + g();
  }
  int plus(int x) { v += x; return v; }
};
int twice(int x) { return 2 * x; }
int add(int a, int b) { return a + b; }

void run()
{
  int n = 1;
  auto by_ref = [&n] { n++; };
  by_ref();
  by_ref();
  num("a", n);
  auto by_copy = [n] { return n; };
  n = 10;
  num("b", by_copy());
  auto all = [&](int x) { n += x; return n; };
  num("c", all(5));
  auto copy_all = [=](int x) { return n + x; };
  n = 0;
  num("d", copy_all(1));
  auto counter = [c = 0]() mutable { return ++c; };
  counter();
  num("e", counter());
  auto second = counter;
  num("f", second());
  auto init = [v = n + 3, &r = n]() { r = v; };
  init();
  num("g", n);
  auto generic = [](auto a, auto b) { return a + b; };
  num("h", generic(1, 2));
  show(generic(std::string("i"), "j"));
  num("k", [](int x) { return x * 2; }(21));
  std::function<int(int)> fact = [&fact](int x) { return x < 2 ? 1 : x * fact(x - 1); };
  num("l", fact(5));
  std::vector<std::function<void()>> fs;
  for (int i = 0; i < 3; ++i) fs.push_back([i] { num("m", i); });
  for (auto & f : fs) f();
  auto nested = [&] { int k = 2; auto in = [&] { k += n; n = 7; return k; }; return in() + k; };
  num("n", nested());
  num("o", n);
  auto make = [](int base) { return [base](int x) { return base + x; }; };
  num("p", make(10)(5));
  static int st = 5;
  auto uses = [] { return ++st; };
  uses();
  num("q", uses());
  constexpr int K = 4;
  auto k = [] { return K * 2; };
  num("r", k());
  S s;
  num("s", s.go());
  num("t", s.v);
  int (*fp)(int) = [](int x) { return x + 1; };
  num("u", fp(1));
  fp = twice;
  num("v", fp(4));
  auto bound = std::bind(add, std::placeholders::_1, 10);
  num("w", bound(5));
  auto mem = std::bind(&S::plus, &s, std::placeholders::_1);
  num("x", mem(3));
  num("y", s.v);
  auto mp = &S::plus;
  num("z", (s.*mp)(1));
  S * sp = &s;
  num("za", (sp->*mp)(1));
  auto mf = std::mem_fn(&S::plus);
  num("zc", mf(s, 1));
  num("zd", std::invoke(&S::plus, s, 2));
  std::function<void()> empty;
  num("ze", empty ? 1 : 0);
  empty = [] {};
  num("zf", empty ? 1 : 0);
  auto [q, w] = std::make_pair(1, 2);
  auto sb = [q = q] { return q; };
  num("zg", sb());
  auto vari = [](auto ... xs) { return (xs + ... + 0); };
  num("zh", vari(1, 2, 3));
  auto mut = [n]() mutable { n += 5; return n; };
  num("zi", mut());
  num("zj", mut());
  num("zk", n);
}
