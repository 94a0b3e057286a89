// SPDX-License-Identifier: Apache-2.0

struct A {
  static int count;
  explicit A(int v) : v_(v) { ++count; } A(const A & o) : v_(o.v_) { ++count; }
  virtual ~A() { --count; }
  virtual int get() const { return v_; }
  void set(int v) { v_ = v; }
  int base() { return get() * 2; }
  protected:
  int v_;
};
int A::count = 0;
struct B : A { B() : A(2) {} int get() const override { return v_ + 100; } };
struct C { int x = 1, y; int z = 3; };
struct D { D() : D(4) { b++; } D(int x) : a(x), b{a + 1} {} int sum() { return a + b; } int a; int b; };
struct E { int v() { return w; } private: int w{12}; };
enum class Color { Red, Green = 5, Blue };
enum { ONE = 1, TWO, THREE };
struct Outer {
  struct Inner { int q() { return k; } int k = 3; };
  static Inner make() { Inner i; i.k = 8; return i; }
};
struct G {
  int v = 1;
  int operator[](int i) { return i * 2; }
  int operator()(int a, int b) { return a + b + v; }
  G operator+(const G & o) const { G r; r.v = v + o.v; return r; }
  int operator-() const { return -v; }
  G & operator+=(int x) { v += x; return *this; }
  bool operator==(const G & o) const { return v == o.v; }
  explicit operator int() const { return v + 50; }
  explicit operator bool() const { return v > 3; }
  G & operator++() { v += 10; return *this; }
  G operator++(int) { G o = *this; v += 100; return o; }
  G & operator*() { return *this; }
  G * operator->() { return this; }
};
struct H { int first; int order; H() : order(5), first(order) { order = 3; } };
struct Fluent {
  int v = 0;
  Fluent & a(int x) { v += x; return *this; }
  Fluent & b(int x) { v += 10 * x; return *this; }
};
template <typename T> struct Crtp { int id() { return static_cast<T *>(this)->impl() + 1; } };
struct K : Crtp<K> { int impl() { return 41; } };
struct L { static L & instance() { static L l; return l; } int n = 3; };
struct M {
  int v;
  explicit M(int x) : v(x) {} M(const M & o) : v(o.v + 1) {} M(M && o) : v(o.v + 10) {}
  M & operator=(const M & o) { v = o.v + 100; return *this; }
};

void run()
{
  A a(1);
  num("a", a.get());
  A b = a;
  b.set(5);
  num("b", a.get());
  num("c", A::count);
  { A c(3); num("d", A::count); } num("e", A::count);
  B d;
  num("f", d.get());
  A & ra = d;
  num("g", ra.get());
  A * pa = new B();
  num("h", pa->get());
  num("i", pa->base());
  delete pa;
  num("j", A::count);
  d.A::set(4);
  num("k", d.A::get());
  std::unique_ptr<A> up = std::make_unique<B>();
  num("l", up->get());
  up.reset();
  num("m", up == nullptr);
  auto sp = std::make_shared<A>(9);
  auto sp2 = sp;
  sp2->set(10);
  num("n", sp->get());
  if (auto pb = dynamic_cast<B *>(sp.get())) num("o", 1);
  else num("o", 0);
  A arr[2] = {A(1), A(2)};
  num("p", arr[1].get());
  std::vector<A> va;
  va.emplace_back(4);
  va.push_back(A(5));
  num("q", va[0].get() + va[1].get());
  C c{1, 2};
  num("r", c.x + c.y + c.z);
  C c2{.x = 5};
  num("s", c2.x + c2.y);
  C c3;
  num("t", c3.z);
  c3 = c;
  num("u", c3.x);
  c3 = {7, 8, 9};
  num("v", c3.z);
  D e;
  num("w", e.sum());
  D f(10);
  num("x", f.sum());
  num("y", E().v());
  num("z", static_cast<int>(Color::Green));
  Color col = Color::Blue;
  num("za", col == Color::Blue);
  num("zb", TWO + THREE);
  num("zc", Outer::Inner().q());
  num("zd", Outer::make().q());
  G g;
  num("ze", g[3]);
  num("zf", g(1, 2));
  num("zg", (g + g).v);
  num("zh", -g);
  g += 5;
  num("zi", g.v);
  num("zj", g == G());
  num("zk", int(g));
  ++g;
  num("zl", g.v);
  g++;
  num("zm", g.v);
  num("zn", bool(g));
  if (g) show("zo");
  num("zp", (*g).v);
  num("zq", g->v);
  H h;
  num("zr", h.order);
  num("zs", Fluent().a(1).b(2).v);
  const A ca(6);
  num("zt", ca.get());
  num("zu", K().id());
  num("zv", L::instance().n++);
  num("zw", L::instance().n);
  M m1(3), m2(m1);
  num("zx", m2.v);
}
