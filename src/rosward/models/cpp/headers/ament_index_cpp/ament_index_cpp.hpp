// SPDX-License-Identifier: Apache-2.0
// ament_index_cpp: where is a package installed?

namespace ament_index_cpp
{
class PackageNotFoundError : public std::out_of_range
{
public:
  std::string package_name;
  PackageNotFoundError(const std::string & name) : std::out_of_range("package '" + name + "' not found"), package_name(name) {}
};

std::string get_package_share_directory(const std::string & package_name) {return rosward::share_folder(package_name);}
std::string get_package_prefix(const std::string & package_name) {return rosward::prefix_folder(package_name);}
std::map<std::string, std::string> get_packages_with_prefixes() {return rosward::unknown("environment", "packages that are installed");}
std::map<std::string, std::string> get_resources(const std::string & resource_type)
{
  return rosward::unknown("environment", "packages that are installed");
}
bool get_resource(
  const std::string & resource_type, const std::string & resource_name, std::string & content, std::string * prefix_path = nullptr)
{
  content = rosward::unknown("environment", "packages that are installed", "str");
  return rosward::unknown("environment", "packages that are installed", "bool");
}
bool has_resource(const std::string & resource_type, const std::string & resource_name, std::string * prefix_path = nullptr)
{
  return rosward::unknown("environment", "packages that are installed", "bool");
}
}  // namespace ament_index_cpp
