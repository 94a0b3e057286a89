// SPDX-License-Identifier: Apache-2.0

// What programs do all day: overloads of which one takes a value and another a reference, what is held but is of others, queues of objects.
struct Settings
{
  std::string name;
  std::vector<std::string> topics;
  void set(std::string n) {name = std::move(n);}
  void set(std::vector<std::string> && v) {topics = std::move(v);}
};

static std::string of(std::vector<int>) {return "vector";}
static std::string of(std::map<std::string, int>) {return "map";}
static std::string of(const std::string &) {return "string";}

static std::string put(bool) {return "truth";}
static std::string put(int) {return "number";}
static std::string put(const std::string &) {return "string";}
static std::string put(const std::vector<std::string> & v) {return "list" + std::to_string(v.size());}

static std::string perhaps(std::optional<int>) {return "optional";}
static std::string perhaps(const std::string &) {return "string";}

static std::string led(std::shared_ptr<int>) {return "shared";}
static std::string led(int *) {return "pointer";}
static std::string led(std::nullptr_t) {return "null";}

static std::string said(const char *) {return "characters";}
static std::string said(int) {return "number";}

struct Adds
{
  template<typename T>
  std::string add(T) {return "any";}
  std::string add(const char *) {return "characters";}
};

struct Lamp
{
  std::string name;
  ~Lamp() {show("end_" + name);}
};
static Lamp * lamp = new Lamp{"of_others"};

struct Logged
{
  std::string * log;
  std::string name;
  ~Logged() {*log += name;}
};

struct Task
{
  int urgency;
  std::string name;
  bool operator<(const Task & other) const {return urgency < other.urgency;}
};
struct Later
{
  int at;
  std::string name;
};
static bool operator>(const Later & a, const Later & b) {return a.at > b.at;}

static void run()
{
  Settings s;
  s.set("n");
  s.set(std::vector<std::string>{"t"});
  show("settings_" + s.name + s.topics[0]);

  show("of_" + of("x"));
  show("of_" + of(std::vector<int>{1}));
  show("put_" + put({"a", "b", "c"}));
  show("put_" + put("a"));
  show("perhaps_" + perhaps("s"));
  show("perhaps_" + perhaps(3));
  show("led_" + led(nullptr));
  show("led_" + led(std::make_shared<int>(1)));
  show("said_" + said('c'));
  show("said_" + said("c"));
  Adds adds;
  show("adds_" + adds.add(std::string("x")));
  show("adds_" + adds.add("x"));

  {
    auto tied = std::tie(*lamp);
    std::tuple<Lamp &, int> pair(*lamp, 1);
    std::vector<std::reference_wrapper<Lamp>> some{*lamp};
    Lamp own{"own"};
  }

  std::string log;
  {
    Logged two[2] = {{&log, "1"}, {&log, "2"}};
    Logged one{&log, "0"};
  }
  show("log_" + log);

  std::priority_queue<Task> tasks;
  tasks.push({1, "a"});
  tasks.push({2, "b"});
  tasks.emplace(Task{0, "c"});
  for (; !tasks.empty(); tasks.pop()) {
    show("task_" + tasks.top().name + std::to_string(tasks.size()));
  }
  std::priority_queue<Later, std::vector<Later>, std::greater<Later>> later;
  later.push({3, "x"});
  later.push({1, "y"});
  show("later_" + later.top().name);
  std::priority_queue<std::pair<int, std::string>> pairs;
  pairs.push({1, "p"});
  pairs.push({4, "q"});
  show("pairs_" + pairs.top().second);
}
