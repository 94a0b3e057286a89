// SPDX-License-Identifier: Apache-2.0
// The program of components: one of each class is made, all are spun.
#include "rclcpp/rclcpp.hpp"

namespace rosward_double
{
namespace
{
std::vector<Factory> & factories()
{
  static std::vector<Factory> all;
  return all;
}
std::vector<std::shared_ptr<Core>> nodes;
}  // namespace

int register_component(const char *, Factory factory)
{
  factories().push_back(std::move(factory));
  return 0;
}
void component(const std::shared_ptr<Core> & node) { nodes.push_back(node); }

int run_components(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  std::vector<std::shared_ptr<void>> made;
  for (const auto & factory : factories()) {
    made.push_back(factory(rclcpp::NodeOptions()));
  }
  finish(nodes);
  return 0;
}
}  // namespace rosward_double
