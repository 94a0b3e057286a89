// SPDX-License-Identifier: Apache-2.0
// diagnostic_updater: a publisher of /diagnostics, two parameters and a timer in which tasks run.
//
// Read from ros/diagnostics, branches ros2 to ros2-jazzy (diagnostic_updater/include/diagnostic_updater/*).

namespace diagnostic_updater
{
class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus
{
public:
  DiagnosticStatusWrapper() {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void summary(const ArgsT & ... args) {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void summaryf(const ArgsT & ... args) {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void mergeSummary(const ArgsT & ... args) {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void mergeSummaryf(const ArgsT & ... args) {}
  void clearSummary() {}
  void clear() {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void add(const ArgsT & ... args) {}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void addf(const ArgsT & ... args) {}
};

using TaskFunction = std::function<void(DiagnosticStatusWrapper &)>;

class DiagnosticTask
{
public:
  explicit DiagnosticTask(const std::string & name) : _name(name) {}
  virtual ~DiagnosticTask() {}
  const std::string & getName() {return _name;}
  virtual void run(DiagnosticStatusWrapper & stat) {}

  std::string _name;
};

template<typename T>
class GenericFunctionDiagnosticTask : public DiagnosticTask
{
public:
  template<typename CallbackT>
  GenericFunctionDiagnosticTask(const std::string & name, CallbackT fn) : DiagnosticTask(name), _function(fn) {}
  void run(DiagnosticStatusWrapper & stat) override {_function(stat);}

  rosward::value _function;
};
using FunctionDiagnosticTask = GenericFunctionDiagnosticTask<DiagnosticStatusWrapper>;

class CompositeDiagnosticTask : public DiagnosticTask
{
public:
  explicit CompositeDiagnosticTask(const std::string & name) : DiagnosticTask(name) {}
  void addTask(DiagnosticTask * task) {_tasks.push_back(task);}
  void run(DiagnosticStatusWrapper & stat) override
  {
    for (auto task : _tasks) {
      task->run(stat);
    }
  }

  std::vector<DiagnosticTask *> _tasks;
};

class DiagnosticTaskVector
{
public:
  virtual ~DiagnosticTaskVector() {}
  template<typename CallbackT, typename... ObjectT>
  void add(const std::string & name, const CallbackT & callback, const ObjectT & ... object)
  {
    if (sizeof...(object) == 0) {
      rosward::schedule([this, callback]() {
          DiagnosticStatusWrapper stat;
          callback(stat);
          _publish(stat);
        }, "timer");
    } else {
      auto bound = rosward::bound(object..., callback);
      rosward::schedule([this, bound]() {
          DiagnosticStatusWrapper stat;
          bound(stat);
          _publish(stat);
        }, "timer");
    }
  }
  void add(DiagnosticTask & task)
  {
    rosward::schedule([this, &task]() {
        DiagnosticStatusWrapper stat;
        task.run(stat);
        _publish(stat);
      }, "timer");
  }
  template<typename... ContentT>
  void _publish(const ContentT & ... content)
  {
    if (_node != nullptr) {
      rosward::send(
        "publication", _node, "/diagnostics", rosward::type<diagnostic_msgs::msg::DiagnosticArray>(),
        std::make_tuple(_hardware, content...));
    }
  }

  rclcpp::AnyNode * _node = nullptr;
  std::string _hardware;
  bool removeByName(const std::string & name) {return true;}
};

class Updater : public DiagnosticTaskVector
{
public:
  bool verbose_ = false;
  template<typename NodeT>
  [[rosward::creator]] explicit Updater(NodeT node, double period = 1.0) {_start(node, period);}
  template<typename BaseT, typename ClockT, typename LoggingT, typename ParametersT, typename TimersT, typename TopicsT>
  [[rosward::creator]] Updater(
    BaseT base, ClockT clock, LoggingT logging, ParametersT parameters, TimersT timers, TopicsT topics, double period = 1.0)
  {
    _start(base, period);
  }
  template<typename BaseT, typename LoggingT, typename ParametersT, typename TimersT, typename TopicsT>
  [[rosward::creator]] Updater(
    BaseT base, LoggingT logging, ParametersT parameters, TimersT timers, TopicsT topics, double period = 1.0)
  {
    _start(base, period);
  }
  template<typename NodeT>
  void _start(NodeT node, double period)
  {
    auto found = rosward::interface_of(node);
    _node = found;
    rosward::create("publisher", found, "/diagnostics", rosward::type<diagnostic_msgs::msg::DiagnosticArray>(), 1);
    if (!found->has_parameter("diagnostic_updater.period")) {
      found->declare_parameter("diagnostic_updater.period", period);
    }
    if (!found->has_parameter("diagnostic_updater.use_fqn")) {
      found->declare_parameter("diagnostic_updater.use_fqn", false);
    }
  }
  void update() {}
  void force_update() {}
  auto getPeriod() const {return rclcpp::Duration(1, 0);}
  template<typename T>
  void setPeriod(const T & period) {}
  template<typename... ArgsT>
  void broadcast(const ArgsT & ... args) {_publish(args...);}
  void setHardwareID(const std::string & hwid) {_hardware = hwid;}
  template<typename... ArgsT>
  [[rosward::changes("self")]] void setHardwareIDf(const ArgsT & ... args) {}
};

struct FrequencyStatusParam
{
  template<typename... ArgsT>
  FrequencyStatusParam(const ArgsT & ... args) {}
};
class FrequencyStatus : public DiagnosticTask
{
public:
  template<typename... ArgsT>
  explicit FrequencyStatus(const ArgsT & ... args) : DiagnosticTask("Frequency Status") {}
  void clear() {}
  void tick() {}
};
struct TimeStampStatusParam
{
  template<typename... ArgsT>
  TimeStampStatusParam(const ArgsT & ... args) {}
};
class TimeStampStatus : public DiagnosticTask
{
public:
  template<typename... ArgsT>
  explicit TimeStampStatus(const ArgsT & ... args) : DiagnosticTask("Timestamp Status") {}
  template<typename T>
  void tick(const T & stamp) {}
};
class Heartbeat : public DiagnosticTask
{
public:
  Heartbeat() : DiagnosticTask("Heartbeat") {}
};
class HeaderlessTopicDiagnostic : public CompositeDiagnosticTask
{
public:
  HeaderlessTopicDiagnostic(std::string name, Updater & diag, const FrequencyStatusParam & freq)
  : CompositeDiagnosticTask(name + " topic status") {diag.add(*this);}
  virtual void tick() {}
  virtual void clear_window() {}
};
class TopicDiagnostic : public HeaderlessTopicDiagnostic
{
public:
  TopicDiagnostic(
    std::string name, Updater & diag, const FrequencyStatusParam & freq, const TimeStampStatusParam & stamp)
  : HeaderlessTopicDiagnostic(name, diag, freq) {}
  template<typename T>
  void tick(const T & stamp) {}
};
template<class MessageT, typename AllocatorT = std::allocator<void>>
class DiagnosedPublisher : public TopicDiagnostic
{
public:
  template<typename PublisherT>
  DiagnosedPublisher(
    const PublisherT & pub, Updater & diag, const FrequencyStatusParam & freq, const TimeStampStatusParam & stamp)
  : TopicDiagnostic(pub->get_topic_name(), diag, freq, stamp), _publisher(pub) {}
  template<typename T>
  void publish(const T & message) {_publisher->publish(message);}
  auto getPublisher() const {return _publisher;}
  template<typename PublisherT>
  void setPublisher(PublisherT pub) {_publisher = pub;}

  rosward::value _publisher;
};
}  // namespace diagnostic_updater
