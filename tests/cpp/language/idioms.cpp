// SPDX-License-Identifier: Apache-2.0

enum class Mode { Off, Manual, Auto };
struct Config {
  std::string topic{"default"};
  int rate = 10;
  std::map<std::string, int> sensors = {{"lidar", 1}};
};
void apply_overrides(Config & c) {
  c.topic += "_x";
  c.rate /= 3;
  c.sensors["imu"] = c.rate;
  c.sensors.emplace("gps", 7);
}
std::string to_str(Mode m) {
  switch (m) {
    case Mode::Off: return "off";
    case Mode::Manual: case Mode::Auto: { std::string s = "on"; return s + "_line"; }
  }
  return "bad";
}
struct Base {
  virtual ~Base() = default;
  virtual std::string name() const { return prefix() + "base"; }
  std::string prefix() const { return "o_"; }
};
struct Derived : public Base { std::string name() const override { return Base::name() + "_derived"; } };
std::vector<std::string> split(const std::string & s, char sep) {
  std::vector<std::string> out;
  std::stringstream ss(s);
  std::string item;
  while (std::getline(ss, item, sep)) { if (item.empty()) continue; out.push_back(item); }
  return out;
}
class Registry {
  public:
  using Fn = std::function<std::string(const std::string &)>;
  void add(const std::string & k, Fn f) { fns_[k] = std::move(f); }
  std::string call(const std::string & k, const std::string & a) {
    auto it = fns_.find(k);
    if (it == fns_.end()) throw std::runtime_error("none");
    return it->second(a);
  }
  size_t size() const { return fns_.size(); }
  private:
  std::unordered_map<std::string, Fn> fns_;
};
struct Shared : std::enable_shared_from_this<Shared> {
  int value = 6;
  std::shared_ptr<Shared> again() { value++; return shared_from_this(); }
};
std::optional<std::string> find(const std::string & k) {
  if (k == "k") return "found";
  return std::nullopt;
}
std::pair<int, int> divide(int a, int b) { return {a / b, a % b}; }
int fib(int n) { return n < 2 ? n : fib(n - 1) + fib(n - 2); }
template <typename T> class Stack {
  std::vector<T> v_;
  public:
  void push(const T & t) { v_.push_back(t); }
  T pop() { T t = v_.back(); v_.pop_back(); return t; }
  size_t depth() const { return v_.size(); }
};
struct Node { int v; Node * next; };
class Builder {
  std::string s_;
  public:
  Builder & with(const std::string & x) { s_ += x; return *this; }
  std::string build() const { return "b" + s_; }
};
class Counter {
  static inline int made_ = 0;
  public:
  Counter() { ++made_; }
  ~Counter() { --made_; }
  static int made() { return made_; }
};
struct Matrix { int v[2][2]; };

void run()
{
  Config cfg;
  apply_overrides(cfg);
  show(cfg.topic);
  num("a", cfg.rate);
  for (const auto & [name, rate] : cfg.sensors) num(name, rate);
  show(to_str(Mode::Auto));
  show(to_str(static_cast<Mode>(0)));
  std::unique_ptr<Base> objs[2] = {std::make_unique<Derived>(), std::make_unique<Base>()};
  for (auto & o : objs) show(o->name());
  auto parts = split("front,back,,left", ',');
  for (size_t i = 0; i < parts.size(); ++i) show("p" + std::to_string(i) + parts[i]);
  auto w = std::weak_ptr<Config>();
  { auto s = std::make_shared<Config>(); w = s; if (auto l = w.lock()) show("locked"); }
  Registry reg;
  reg.add("z", [](const std::string & s) { return s + "!"; });
  show(reg.call("z", "b").substr(0, 1) + "c");
  num("size", reg.size());
  auto self = std::make_shared<Shared>();
  num("d", self->again()->value);
  std::variant<int, std::string> v = 3;
  std::visit([](auto && x) { using T = std::decay_t<decltype(x)>; if constexpr (std::is_same_v<T, int>) num("vi", x); else show("vs" + x); }, v);
  v = std::string("q");
  if (std::holds_alternative<std::string>(v)) show("h" + std::get<std::string>(v));
  if (auto p = std::get_if<int>(&v)) num("no", *p);
  else show("e");
  static const std::map<Mode, std::string> kNames = {{Mode::Off, "off"}, {Mode::Auto, "auto"}};
  show("n_" + kNames.at(Mode::Auto));
  for (auto it = kNames.begin(); it != kNames.end(); ++it) show("it_" + it->second);
  constexpr std::array<const char *, 2> kTopics{"left", "right"};
  for (auto t : kTopics) show(std::string("k_") + t);
  for (size_t i = 0; i < kTopics.size(); i++) num(kTopics[i], i);
  std::ostringstream os;
  os << "wheel" << 3 << "_" << std::setw(2) << std::setfill('0') << 7;
  show(os.str());
  char buf[32];
  snprintf(buf, sizeof(buf), "cam%02d", 4);
  show(buf);
  std::string path = "/a/b/";
  if (!path.empty() && path.back() == '/') path.pop_back();
  show(path);
  show(path.substr(path.rfind('/') + 1));
  std::string up = "Abc";
  std::transform(up.begin(), up.end(), up.begin(), ::tolower);
  show(up);
  std::vector<int> nums{5, 3, 8};
  std::sort(nums.begin(), nums.end());
  num("min", nums.front());
  num("sum", std::accumulate(nums.begin(), nums.end(), 0));
  auto big = std::find_if(nums.begin(), nums.end(), [](int x) { return x > 4; });
  num("big", *big);
  nums.erase(std::remove(nums.begin(), nums.end(), 5), nums.end());
  num("left", nums.size());
  std::optional<std::string> maybe = find("k");
  show(maybe ? *maybe : "none");
  show(find("zz").value_or("fallback"));
  if (auto f = find("k"); f.has_value()) show("has" + f.value());
  const auto [q, r] = divide(17, 5);
  num("q", q);
  num("r", r);
  int total = 0;
  auto add = [&total](auto ... xs) { ((total += xs), ...); };
  add(1, 2, 3);
  num("total", total);
  Stack<int> st;
  st.push(4);
  st.push(5);
  num("top", st.pop());
  num("depth", st.depth());
  Node n1{1, nullptr}, n2{2, &n1};
  int s = 0;
  for (Node * p = &n2; p; p = p->next) s += p->v;
  num("list", s);
  show(Builder().with("x").with("y").build());
  num("count", Counter::made());
  { Counter c1, c2; num("count", Counter::made()); } num("count2", Counter::made());
  num("tern", cfg.rate > 10 ? 1 : cfg.rate > 5 ? 2 : 3);
  using Clock = std::pair<int, int>;
  Clock c{1, 2};
  std::swap(c.first, c.second);
  num("sw", c.first);
  const char * names[] = {"aa", "bb"};
  for (auto & nm : names) show(nm);
  int idx = 0;
  for (const std::string nm : {"cc", "dd"}) show(nm + std::to_string(idx++));
  num("cmp", std::string("a") < std::string("b"));
  num("neg", -5 / 2);
  num("mod", -5 % 3);
  unsigned char uc = 200;
  num("uc", uc + 100);
  double dd = 2.5;
  num("round", static_cast<int>(dd + 0.5));
  show("f" + std::to_string(1.5).substr(0, 3).replace(1, 1, "_"));
  num("stoi", std::stoi("42") + std::atoi("8"));
  show(std::string(3, 'z'));
  show(std::string("abc").insert(1, "X"));
  num("npos", std::string("abc").find('x') == std::string::npos);
  std::string joined;
  for (const auto & p : parts) { if (!joined.empty()) joined += "_"; joined += p; } show("j" + joined);
  num("any", std::any_of(nums.begin(), nums.end(), [](int x) { return x == 8; }));
  num("cnt", std::count(parts.begin(), parts.end(), "left"));
}
