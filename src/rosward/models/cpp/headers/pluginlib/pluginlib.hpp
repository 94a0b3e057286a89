// SPDX-License-Identifier: Apache-2.0
// pluginlib: classes that are made by their names. Those of the workspace are made as they are, others nobody knows.
//
// `of_workspace` and `names_in_workspace` are written for each workspace. Read from ros/pluginlib, branches humble to rolling
// (class_loader.hpp, class_loader_base.hpp, exceptions.hpp).

namespace pluginlib
{
class PluginlibException : public std::runtime_error
{
public:
  PluginlibException(const std::string & message = "") : std::runtime_error(message) {}
};
class LibraryLoadException : public PluginlibException
{
public:
  LibraryLoadException(const std::string & message = "") : PluginlibException(message) {}
};
class ClassLoaderException : public PluginlibException
{
public:
  ClassLoaderException(const std::string & message = "") : PluginlibException(message) {}
};
class LibraryUnloadException : public PluginlibException
{
public:
  LibraryUnloadException(const std::string & message = "") : PluginlibException(message) {}
};
class CreateClassException : public PluginlibException
{
public:
  CreateClassException(const std::string & message = "") : PluginlibException(message) {}
};

class ClassLoaderBase
{
public:
  virtual ~ClassLoaderBase() {}
};

template<class T>
using UniquePtr = std::unique_ptr<T>;

template<class T>
class ClassLoader : public ClassLoaderBase
{
public:
  template<typename... ArgsT>
  ClassLoader(const std::string & package, const std::string & base_class, const ArgsT & ... args) : _base(base_class) {}

  std::shared_ptr<T> createSharedInstance(const std::string & lookup_name)
  {
    return _made(lookup_name);
  }
  std::unique_ptr<T> createUniqueInstance(const std::string & lookup_name)
  {
    return _made(lookup_name);
  }
  T * createUnmanagedInstance(const std::string & lookup_name) {return _made(lookup_name);}
  // A name that is a default is taken to be the one; there may be no class of another.
  std::shared_ptr<T> _made(const std::string & lookup_name)
  {
    const auto names = rosward::plugin_names(lookup_name);
    if (!rosward::is_same_plugin(names, lookup_name)) {
      throw LibraryLoadException(lookup_name);
    }
    return pluginlib::of_workspace(_base, names);
  }
  std::vector<std::string> getDeclaredClasses() {return pluginlib::names_in_workspace(_base);}
  std::vector<std::string> getRegisteredLibraries() {return rosward::unknown("environment", "libraries of plugins");}
  std::string getBaseClassType() const {return _base;}
  std::string getName(const std::string & lookup_name)
  {
    const auto slash = lookup_name.rfind('/');
    const auto colon = lookup_name.rfind(':');
    if (slash != std::string::npos) {
      return lookup_name.substr(slash + 1);
    }
    return colon == std::string::npos ? lookup_name : lookup_name.substr(colon + 1);
  }
  std::string getClassType(const std::string & lookup_name) {return rosward::unknown("environment", "class of a plugin", "str");}
  std::string getClassPackage(const std::string & lookup_name) {return rosward::unknown("environment", "package of a plugin", "str");}
  bool isClassAvailable(const std::string & lookup_name) {return rosward::unknown("environment", "plugins that are installed", "bool");}
  bool isClassLoaded(const std::string & lookup_name) {return rosward::unknown("live", "whether a library is loaded", "bool");}
  void loadLibraryForClass(const std::string & lookup_name) {}
  int unloadLibraryForClass(const std::string & lookup_name) {return 0;}
  void refreshDeclaredClasses() {}

  std::string _base;
};
}  // namespace pluginlib
