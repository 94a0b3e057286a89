// SPDX-License-Identifier: Apache-2.0
// rclcpp: how does a process begin and end? Contexts, `init`, `ok`, `shutdown`.
//
// Read from rclcpp, branches humble, jazzy and rolling (context.hpp, init_options.hpp, utilities.hpp).

namespace rclcpp
{
enum class SignalHandlerOptions { All, SigInt, SigTerm, None };

class InitOptions
{
public:
  bool shutdown_on_signal = true;
  InitOptions() {}
  bool auto_initialize_logging() const;
  InitOptions & auto_initialize_logging(bool initialize_logging) {return *this;}
  void use_default_domain_id() {}
  void set_domain_id(size_t domain_id) {}
  size_t get_domain_id() const;
};

class ShutdownCallbackHandle {};
using OnShutdownCallbackHandle = ShutdownCallbackHandle;
using PreShutdownCallbackHandle = ShutdownCallbackHandle;

class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)
  using OnShutdownCallback = std::function<void()>;
  using PreShutdownCallback = std::function<void()>;

  Context() {}
  virtual ~Context() {}
  virtual void init(int argc, char const * const * argv, const InitOptions & init_options = InitOptions())
  {
    rosward::init(this, argc, argv);
  }
  bool is_valid() const;
  InitOptions get_init_options() const {return InitOptions();}
  size_t get_domain_id() const;
  std::string shutdown_reason() const;
  virtual bool shutdown(const std::string & reason) {return true;}
  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback)
  {
    rosward::schedule(callback, "shutdown");
    return callback;
  }
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback)
  {
    rosward::schedule(callback, "shutdown");
    return OnShutdownCallbackHandle();
  }
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(PreShutdownCallback callback)
  {
    rosward::schedule(callback, "shutdown");
    return PreShutdownCallbackHandle();
  }
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle & callback_handle) {return true;}
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & callback_handle) {return true;}
  bool sleep_for(const std::chrono::nanoseconds & nanoseconds);
  void interrupt_all_sleep_for() {}
};

namespace contexts
{
class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
};
DefaultContext::SharedPtr get_global_default_context()
{
  static DefaultContext::SharedPtr context = std::make_shared<DefaultContext>();
  return context;
}
namespace default_context
{
using rclcpp::contexts::DefaultContext;
using rclcpp::contexts::get_global_default_context;
}
}  // namespace contexts

std::vector<Context::SharedPtr> get_contexts() {return {contexts::get_global_default_context()};}

void init(
  int argc, char const * const * argv, const InitOptions & init_options = InitOptions(),
  SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All)
{
  rosward::init(contexts::get_global_default_context(), argc, argv);
}
std::vector<std::string> init_and_remove_ros_arguments(
  int argc, char const * const * argv, const InitOptions & init_options = InitOptions())
{
  rosward::init(contexts::get_global_default_context(), argc, argv);
  return rosward::remove_ros_arguments(argc, argv);
}
std::vector<std::string> remove_ros_arguments(int argc, char const * const * argv)
{
  return rosward::remove_ros_arguments(argc, argv);
}
bool install_signal_handlers(SignalHandlerOptions signal_handler_options = SignalHandlerOptions::All) {return true;}
bool uninstall_signal_handlers() {return true;}
bool signal_handlers_installed();
bool ok(Context::SharedPtr context = nullptr) {return rosward::unknown("live", "whether the process is to end", "bool");}
bool is_initialized(Context::SharedPtr context = nullptr)
{
  return rosward::unknown("live", "whether the process is to end", "bool");
}
bool shutdown(Context::SharedPtr context = nullptr, const std::string & reason = "") {return true;}
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr)
{
  rosward::schedule(callback, "shutdown");
}
bool sleep_for(const std::chrono::nanoseconds & nanoseconds, Context::SharedPtr context = nullptr) {std::this_thread::yield(); return true;}
const char * get_c_string(const std::string & string_in) {return string_in;}
}  // namespace rclcpp
