// SPDX-License-Identifier: Apache-2.0
// rcutils: which words of its C interface do programs write?
//
// Read from ros2/rcutils, branches humble to rolling (cmdline_parser.c, env.h, filesystem.h, types/rcutils_ret.h).

typedef int rcutils_ret_t;
const int RCUTILS_RET_OK = 0;
const int RCUTILS_RET_ERROR = 2;

// The first word is the program itself.
bool rcutils_cli_option_exist(char ** begin, char ** end, const char * option)
{
  return std::find(begin + 1, end, std::string(option)) != end;
}
char * rcutils_cli_get_option(char ** begin, char ** end, const char * option)
{
  auto found = std::find(begin + 1, end, std::string(option));
  if (found != end && ++found != end) {
    return *found;
  }
  return nullptr;
}
const char * rcutils_get_env(const char * name, const char ** value)
{
  *value = std::getenv(name);
  return nullptr;
}
bool rcutils_set_env(const char * name, const char * value) {return true;}
const char * rcutils_get_home_dir() {return std::getenv("HOME");}
bool rcutils_exists(const char * path) {return rosward::unknown("environment", "files of the machine", "bool");}
bool rcutils_is_directory(const char * path) {return rosward::unknown("environment", "files of the machine", "bool");}
bool rcutils_is_file(const char * path) {return rosward::unknown("environment", "files of the machine", "bool");}
