// SPDX-License-Identifier: Apache-2.0
// What the methods of a node do that need no types.
#include "rclcpp/node.hpp"

#include <cstring>

#include "rclcpp/parameter_client.hpp"
#include "rosward_double/names.hpp"

namespace rosward_double
{
std::shared_ptr<Entity> statistics(Core & node, const std::string & topic)
{
  node.create("pub", topic, "statistics_msgs/msg/MetricsMessage");
  return std::make_shared<Entity>();
}
}  // namespace rosward_double

namespace rclcpp
{
NodeMethods::NodeMethods(const std::string & name, const std::string & space, const NodeOptions & options)
: core_(std::make_shared<rosward_double::Core>(name, space, options)), options_(options),
  base_(std::make_shared<node_interfaces::NodeBaseInterface>(core_))
{
  auto & parameters = *core_->parameters;
  if (options.automatically_declare_parameters_from_overrides()) {
    for (const auto & [key, value] : parameters.overrides) {
      Descriptor descriptor;
      descriptor.dynamic_typing = true;
      parameters.declare(*core_, key, value.get_type(), value, descriptor, true);
    }
  }
  for (const auto & [key, value] : {std::pair("use_sim_time", false), std::pair("start_type_description_service", true)}) {
    if (!has_parameter(key)) {
      declare_parameter(key, ParameterValue(value));
    }
  }
  if (get_parameter("start_type_description_service").as_bool()) {
    core_->system("ss", core_->full_name() + "/get_type_description", "type_description_interfaces/srv/GetTypeDescription");
  }
}

NodeMethods::NodeMethods(const NodeMethods & parent, const std::string & sub)
: core_(parent.core_), sub_(parent.prefixed(sub)), options_(parent.options_), base_(parent.base_)
{
  if (sub.empty() || sub[0] == '/') {
    throw exceptions::NameValidationError("a sub-namespace is relative and not empty");
  }
}

std::string NodeMethods::prefixed(const std::string & name) const
{
  return sub_.empty() || name.empty() || name[0] == '/' || name[0] == '~' ? name : sub_ + "/" + name;
}

std::string NodeMethods::get_effective_namespace() const { return sub_.empty() ? core_->space() : rosward_double::joined(core_->space(), sub_); }

GenericPublisher::SharedPtr NodeMethods::create_generic_publisher(const std::string & topic, const std::string & type, const QoS &, const PublisherOptions &)
{
  auto made = std::make_shared<GenericPublisher>(core_->create("pub", prefixed(topic), type));
  core_->own(made);
  return made;
}
GenericClient::SharedPtr NodeMethods::create_generic_client(const std::string & name, const std::string & type, const QoS &, CallbackGroup::SharedPtr)
{
  auto made = std::make_shared<GenericClient>(core_->create("sc", prefixed(name), type));
  core_->own(made);
  return made;
}

const ParameterValue & NodeMethods::declare_parameter(
  const std::string & name, const ParameterValue & value, const Descriptor & descriptor, bool ignore_override)
{
  return core_->parameters->declare(*core_, name, value.get_type(), value, descriptor, ignore_override);
}
const ParameterValue & NodeMethods::declare_parameter(
  const std::string & name, ParameterType type, const Descriptor & descriptor, bool ignore_override)
{
  return core_->parameters->declare(*core_, name, type, ParameterValue(), descriptor, ignore_override);
}
void NodeMethods::undeclare_parameter(const std::string & name)
{
  if (core_->parameters->declared.erase(name) == 0) {
    throw exceptions::ParameterNotDeclaredException("cannot undeclare parameter '" + name + "' which has not yet been declared");
  }
}
bool NodeMethods::has_parameter(const std::string & name) const { return core_->parameters->declared.count(name) != 0; }
rcl_interfaces::msg::ListParametersResult NodeMethods::list_parameters(
  const std::vector<std::string> & prefixes, uint64_t depth) const
{
  rcl_interfaces::msg::ListParametersResult listed;
  const auto near = [depth](const std::string & rest) {
      return depth == 0 || static_cast<uint64_t>(std::count(rest.begin(), rest.end(), '.')) < depth;
    };
  for (const auto & [name, value] : below("")) {
    bool chosen = prefixes.empty() && near(name);
    for (const auto & prefix : prefixes) {
      const auto first = prefix + ".";
      chosen = chosen || name == prefix || (name.rfind(first, 0) == 0 && near(name.substr(first.size())));
    }
    if (!chosen) {
      continue;
    }
    listed.names.push_back(name);
    const auto last = name.rfind('.');
    const auto above = last == std::string::npos ? "" : name.substr(0, last);
    if (!above.empty() && std::find(listed.prefixes.begin(), listed.prefixes.end(), above) == listed.prefixes.end()) {
      listed.prefixes.push_back(above);
    }
  }
  return listed;
}
std::vector<NodeMethods::Result> NodeMethods::set_parameters(const std::vector<Parameter> & changed)
{
  return core_->parameters->set(*core_, changed, false);
}
NodeMethods::Result NodeMethods::set_parameters_atomically(const std::vector<Parameter> & changed)
{
  return core_->parameters->set(*core_, changed, true).at(0);
}
Parameter NodeMethods::get_parameter(const std::string & name) const { return core_->parameters->get(name); }
bool NodeMethods::get_parameter(const std::string & name, Parameter & found) const { return core_->parameters->get(name, found); }
std::vector<Parameter> NodeMethods::get_parameters(const std::vector<std::string> & names) const
{
  std::vector<Parameter> found;
  for (const auto & name : names) {
    found.push_back(get_parameter(name));
  }
  return found;
}
std::map<std::string, Parameter> NodeMethods::below(const std::string & prefix) const
{
  std::map<std::string, Parameter> found;
  const std::string start = prefix.empty() ? "" : prefix + ".";
  for (const auto & [name, declared] : core_->parameters->declared) {
    if (name.compare(0, start.size(), start) == 0) {
      found.emplace(name.substr(start.size()), Parameter(name, declared.value));
    }
  }
  return found;
}
NodeMethods::Descriptor NodeMethods::describe_parameter(const std::string & name) const
{
  const auto found = core_->parameters->declared.find(name);
  if (found == core_->parameters->declared.end()) {
    throw exceptions::ParameterNotDeclaredException(name);
  }
  return found->second.descriptor;
}
std::vector<uint8_t> NodeMethods::get_parameter_types(const std::vector<std::string> & names) const
{
  std::vector<uint8_t> types;
  for (const auto & name : names) {
    types.push_back(describe_parameter(name).type);
  }
  return types;
}

node_interfaces::OnSetParametersCallbackHandle::SharedPtr NodeMethods::add_on_set_parameters_callback(
  node_interfaces::OnSetParametersCallbackHandle::Callback callback)
{
  auto handle = std::make_shared<node_interfaces::OnSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  core_->parameters->on_set.push_back(handle);
  return handle;
}
node_interfaces::PostSetParametersCallbackHandle::SharedPtr NodeMethods::add_post_set_parameters_callback(
  node_interfaces::PostSetParametersCallbackHandle::Callback callback)
{
  auto handle = std::make_shared<node_interfaces::PostSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  core_->parameters->post_set.push_back(handle);
  return handle;
}
node_interfaces::PreSetParametersCallbackHandle::SharedPtr NodeMethods::add_pre_set_parameters_callback(
  node_interfaces::PreSetParametersCallbackHandle::Callback callback)
{
  auto handle = std::make_shared<node_interfaces::PreSetParametersCallbackHandle>();
  handle->callback = std::move(callback);
  core_->parameters->pre_set.push_back(handle);
  return handle;
}
void NodeMethods::remove_on_set_parameters_callback(const node_interfaces::OnSetParametersCallbackHandle * handle)
{
  auto & all = core_->parameters->on_set;
  for (auto each = all.begin(); each != all.end(); ++each) {
    if (each->lock().get() == handle) {
      all.erase(each);
      return;
    }
  }
}

AsyncParametersClient::AsyncParametersClient(rosward_double::Core & node, const std::string & remote) : node_(node.shared_from_this())
{
  const std::string base = (remote.empty() ? node.full_name() : remote) + "/";
  for (const auto & [name, type] : std::map<std::string, std::string>{
      {"describe_parameters", "DescribeParameters"}, {"get_parameter_types", "GetParameterTypes"}, {"get_parameters", "GetParameters"},
      {"list_parameters", "ListParameters"}, {"set_parameters", "SetParameters"}, {"set_parameters_atomically", "SetParametersAtomically"}}) {
    node.create("sc", base + name, "rcl_interfaces/srv/" + type);
  }
}
std::shared_future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
  const std::vector<std::string> &, std::function<void(std::shared_future<std::vector<Parameter>>)> callback)
{
  std::promise<std::vector<Parameter>> promise;
  promise.set_value({});
  auto future = promise.get_future().share();
  if (callback) {
    callback(future);
  }
  return future;
}
std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>> AsyncParametersClient::set_parameters(
  const std::vector<Parameter> & parameters,
  std::function<void(std::shared_future<std::vector<rcl_interfaces::msg::SetParametersResult>>)> callback)
{
  std::promise<std::vector<rcl_interfaces::msg::SetParametersResult>> promise;
  promise.set_value(std::vector<rcl_interfaces::msg::SetParametersResult>(parameters.size()));
  auto future = promise.get_future().share();
  if (callback) {
    callback(future);
  }
  return future;
}

ParameterEventHandler::ParameterEventHandler(rosward_double::Core & node) { node.create("sub", "/parameter_events", "rcl_interfaces/msg/ParameterEvent"); }
ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
  const std::string &, std::function<void(const Parameter &)>, const std::string &)
{
  return std::make_shared<ParameterCallbackHandle>();
}
ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(
  std::function<void(const rcl_interfaces::msg::ParameterEvent &)>)
{
  return std::make_shared<ParameterEventCallbackHandle>();
}
}  // namespace rclcpp
