// SPDX-License-Identifier: Apache-2.0
// rclcpp_components: the node of a component container, and how a component is loaded.
//
// Read from rclcpp_components, branches humble, jazzy and rolling (component_manager.hpp, node_factory.hpp, node_factory_template.hpp).

namespace rclcpp_components
{
class NodeInstanceWrapper
{
public:
  NodeInstanceWrapper() {}
  template<typename... ArgsT>
  NodeInstanceWrapper(const ArgsT & ... args) : _node(args...) {}
  const rclcpp::AnyNode * get_node_base_interface() {return _node;}
  std::shared_ptr<void> get_node_instance() const {return _node;}

  rosward::value _node;
};

class NodeFactory
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeFactory)
  virtual ~NodeFactory() {}
};

template<typename NodeT>
class NodeFactoryTemplate : public NodeFactory
{
public:
  NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options)
  {
    return NodeInstanceWrapper(std::make_shared<NodeT>(options));
  }
};

class [[rosward::node_class]] ComponentManager : public rclcpp::Node
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ComponentManager)
  template<typename ExecutorT = std::shared_ptr<rclcpp::Executor>>
  ComponentManager(
    ExecutorT executor = nullptr, std::string node_name = "ComponentManager",
    const rclcpp::NodeOptions & node_options =
    rclcpp::NodeOptions().start_parameter_services(false).start_parameter_event_publisher(false))
  : rclcpp::Node(node_name, node_options)
  {
    rosward::create(
      "service_server", this, "~/_container/load_node", rosward::type<composition_interfaces::srv::LoadNode>(), 10);
    rosward::create(
      "service_server", this, "~/_container/unload_node", rosward::type<composition_interfaces::srv::UnloadNode>(), 10);
    rosward::create(
      "service_server", this, "~/_container/list_nodes", rosward::type<composition_interfaces::srv::ListNodes>(), 10);
  }
  void set_executor(const std::weak_ptr<rclcpp::Executor> executor) {}
};

template<typename ExecutorT = rclcpp::executors::SingleThreadedExecutor>
class ComponentManagerIsolated : public ComponentManager
{
public:
  template<typename... ArgsT>
  explicit ComponentManagerIsolated(const ArgsT & ... args) : ComponentManager(args...) {}
};

// What a container does with a component that is loaded into it, and the executable that rclcpp_components_register_node makes of one.
template<typename NodeT>
void host(const std::vector<std::string> & arguments, bool use_global_arguments)
{
  rclcpp::NodeOptions options;
  options.arguments(arguments).use_global_arguments(use_global_arguments);
  auto component = std::make_shared<NodeT>(options);
  rosward::spun(component->get_node_base_interface());
  rosward::spin();
}
}  // namespace rclcpp_components
