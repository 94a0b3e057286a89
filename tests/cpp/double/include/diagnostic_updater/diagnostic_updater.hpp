// SPDX-License-Identifier: Apache-2.0
// Diagnostics: each task is run when the node is spun.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "diagnostic_msgs/msg/diagnostic_status.hpp"
#include "rclcpp/rclcpp.hpp"

namespace diagnostic_updater
{
class DiagnosticStatusWrapper : public diagnostic_msgs::msg::DiagnosticStatus
{
public:
  void summary(unsigned char level_, const std::string & text)
  {
    level = level_;
    message = text;
  }
  template<typename ... T>
  void summaryf(unsigned char level_, const char * text, T ...)
  {
    summary(level_, text);
  }
  template<typename T>
  void add(const std::string &, const T &)
  {
  }
  template<typename ... T>
  void addf(const std::string &, const char *, T ...)
  {
  }
};

class DiagnosticTask
{
public:
  explicit DiagnosticTask(const std::string & name) : name_(name) {}
  virtual ~DiagnosticTask() = default;
  virtual void run(DiagnosticStatusWrapper &) = 0;
  const std::string & getName() const { return name_; }

private:
  std::string name_;
};

class Updater
{
public:
  using Task = std::function<void(DiagnosticStatusWrapper &)>;
  template<typename N>
  explicit Updater(N && node, double period = 1.0) : Updater(*rosward_double::core_of(node), period)
  {
    auto & parameters = rosward_double::pointed(node);
    parameters.declare_parameter("diagnostic_updater.period", period);
    parameters.declare_parameter("diagnostic_updater.use_fqn", false);
  }
  void setHardwareID(const std::string &) {}
  template<typename ... T>
  void setHardwareIDf(const char *, T ...)
  {
  }
  void add(const std::string &, Task task) { tasks_->push_back(std::move(task)); }
  template<typename C>
  void add(const std::string &, C * object, void (C::* method)(DiagnosticStatusWrapper &))
  {
    tasks_->push_back([object, method](DiagnosticStatusWrapper & status) { (object->*method)(status); });
  }
  void add(DiagnosticTask & task)
  {
    tasks_->push_back([&task](DiagnosticStatusWrapper & status) { task.run(status); });
  }
  void force_update() { run(); }
  void broadcast(unsigned char, const std::string &) {}

private:
  Updater(rosward_double::Core & node, double)
  : publisher_(rosward_double::publisher<diagnostic_msgs::msg::DiagnosticArray>(node, "/diagnostics")),
    timer_(rosward_double::timer(node, [this] { run(); }))
  {
  }
  void run()
  {
    const auto tasks = *tasks_;
    for (const auto & task : tasks) {
      DiagnosticStatusWrapper status;
      task(status);
    }
  }
  std::shared_ptr<std::vector<Task>> tasks_ = std::make_shared<std::vector<Task>>();
  std::shared_ptr<rosward_double::Entity> publisher_, timer_;
};
}  // namespace diagnostic_updater
