// SPDX-License-Identifier: Apache-2.0

struct Animal {
  std::string name;
  std::string log;
  int calls = 0;
  explicit Animal(const std::string & n) : name(n) { init(); }
  virtual ~Animal() {}
  void init() { calls += kind(); }
  virtual int kind() { return 1; }
  virtual std::string who() const { return "animal_" + name; }
  void hook() { before(); log += "hook"; after(); }
  protected:
  virtual void before() { log += "b_"; }
  virtual void after() { log += "_a"; }
};
struct Dog : Animal {
  static int count;
  explicit Dog(const std::string & n) : Animal(n) {
    calls += 10;
    init();
    ++count;
  } Dog(const Dog & o) : Animal(o) { ++count; }
  ~Dog() override { --count; }
  int kind() override { return 100; }
  std::string who() const override { return "dog_" + name; }
  static int population() { return count; }
  int add(int a, int b) { return a + b; }
  protected:
  void before() override { Animal::before(); log += "dog_"; }
};
int Dog::count = 0;
struct Handler {
  int total = 0;
  std::vector<std::function<void(int)>> cbs;
  void on(int v) { total += v; }
  void setup() {
    cbs.push_back([this](int v) { on(v); });
    cbs.push_back(std::bind(&Handler::on, this, std::placeholders::_1));
    cbs.emplace_back([this, k = 2](int v) { total += v * k; });
  }
  void fire(int v) { for (auto & c : cbs) c(v); }
};
struct Left { int lx = 1; int x() { return lx; } };
struct Right { int ry = 2; int y() { return ry; } };
struct Multi : Left, Right { Multi() { lx = 10; ry = 20; } };
struct Top { int t = 5; };
struct A1 : virtual Top {};
struct A2 : virtual Top {};
struct Bottom : A1, A2 { int v() { t++; return A1::t + A2::t; } };
struct Order { int a, b; int sum; Order() : b(2), a(b0()), sum(a + b) {} int b0() { return 7; } };
template <typename T> struct Temp { template <typename U> T call(U u) { return static_cast<T>(u * 2.6); } };
class Friendly { int secret = 9; friend struct Peek; public: int peek() { return secret; } };
struct Op {
  int v;
  bool operator<(const Op & o) const { return v < o.v; }
  Op operator+(const Op & o) const { return Op{v + o.v}; }
  int operator()(int k) const { return v * k; }
  Op & operator+=(const Op & o) { v += o.v; return *this; }
};
struct Singleton {
  static Singleton & get() { static Singleton s; return s; }
  void add() { n++; }
  int n = 0;
  private:
  Singleton() = default;
};
struct Nested { enum E { A, B = 4 }; struct Inner { int v = B; }; };
class Lazy {
  mutable std::optional<int> cache_;
  mutable int n_ = 0;
  public:
  int value() const { if (!cache_) { cache_ = ++n_ * 3; } return *cache_; }
};
struct Interface { virtual int run() = 0; virtual ~Interface() = default; };
struct Final final : Interface { int run() override { return 8; } };
void delete_me(Animal * a) { delete a; }
struct Conv { int v; Conv(int x) : v(x) {} operator std::string() const { return std::string(v, 'q'); } };
void takes_conv(const Conv & c) { num("tc", c.v); }
int sum_of(const int * a, int n) { int s = 0; for (int i = 0; i < n; ++i) s += a[i]; return s; }
int defaults(int a, int b = 10, int c = 100) { return a + b + c; }
template <typename T> class Wrapper {
  T t_;
  public:
  explicit Wrapper(T t) : t_(std::move(t)) {}
  T * operator->() { return &t_; }
  T & operator*() { return t_; }
};

void run()
{
  Dog d("rex");
  num("ctor", d.calls);
  show(d.who());
  Animal & a = d;
  show("r" + a.who());
  Animal * p = &d;
  show("p" + p->who());
  p->hook();
  show(d.log);
  Animal copy = d;
  show("s" + copy.who());
  std::vector<std::shared_ptr<Animal>> zoo{std::make_shared<Dog>("a"), std::make_shared<Animal>("b")};
  for (const auto & z : zoo) show("z" + z->who());
  if (auto dg = std::dynamic_pointer_cast<Dog>(zoo[0])) show("cast" + dg->name);
  num("isnull", std::dynamic_pointer_cast<Dog>(zoo[1]) == nullptr);
  auto up = std::make_unique<Dog>("u");
  std::unique_ptr<Animal> owner = std::move(up);
  show("o" + owner->who());
  Handler h;
  h.setup();
  h.fire(3);
  num("h", h.total);
  h.fire(4);
  num("h2", h.total);
  Multi m;
  num("m", m.x() + m.y());
  Left & l = m;
  num("l", l.x());
  num("diamond", Bottom().v());
  num("order", Order().sum);
  Temp<int> t;
  num("t", t.call(2));
  num("priv", Friendly().peek());
  const Dog cd("c");
  show("const" + cd.who());
  Op o1{1}, o2{2};
  num("lt", o1 < o2);
  num("out", (o1 + o2).v);
  num("call", o1(5));
  o1 += o2;
  num("pe", o1.v);
  std::map<Op, int> om;
  om[o1] = 4;
  om[Op{3}] += 1;
  num("om", om.size());
  num("omv", om.begin()->second);
  num("statics", Dog::population());
  Singleton::get().add();
  Singleton::get().add();
  num("single", Singleton::get().n);
  Nested::Inner in;
  num("inner", in.v);
  num("enum", Nested::B);
  Lazy lz;
  num("lazy", lz.value());
  num("lazy2", lz.value());
  auto fn = std::bind(&Dog::add, &d, std::placeholders::_1, 10);
  num("bind", fn(5));
  using Method = int (Dog::*)(int, int);
  Method mm = &Dog::add;
  num("mp", (d.*mm)(1, 2));
  Dog * dp = &d;
  num("mpp", (dp->*mm)(3, 4));
  std::function<int(Dog &, int, int)> mf = &Dog::add;
  num("mf", mf(d, 5, 6));
  Final f;
  num("final", f.run());
  Interface * ip = &f;
  num("iface", ip->run());
  delete_me(new Dog("x"));
  num("pop2", Dog::population());
  Conv c = 5;
  num("conv", c.v);
  takes_conv(7);
  int arr[] = {1, 2, 3};
  num("range", sum_of(arr, 3));
  num("defaults", defaults(1) + defaults(1, 2) + defaults(1, 2, 3));
  Wrapper<Dog> w(Dog("w"));
  show("w" + w->who());
  show("w2" + (*w).who());
}
