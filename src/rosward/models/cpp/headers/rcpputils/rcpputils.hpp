// SPDX-License-Identifier: Apache-2.0
// rcpputils and rcutils: small helpers that names are made with.

namespace rcpputils
{
class AssertionException : public std::exception {};
class IllegalStateException : public std::exception {};

bool check_true(bool condition, const std::string & message = "") {return condition;}
void require_true(bool condition, const std::string & message = "") {}
void assert_true(bool condition, const std::string & message = "") {}

template<typename ContainerT>
std::string join(const ContainerT & container, const std::string & delimiter)
{
  std::string joined;
  bool first = true;
  for (const auto & part : container) {
    joined += first ? std::string(part) : delimiter + part;
    first = false;
  }
  return joined;
}
std::vector<std::string> split(const std::string & input, char delimiter, bool skip_empty = false)
{
  std::vector<std::string> parts;
  std::istringstream stream(input);
  std::string part;
  while (std::getline(stream, part, delimiter)) {
    if (!skip_empty || !part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}
std::string get_env_var(const char * name) {return std::getenv(name);}
bool set_env_var(const char * name, const char * value) {return true;}
std::string find_and_replace(const std::string & input, const std::string & find, const std::string & replace)
{
  std::string output = input;
  size_t position = output.find(find);
  while (position != std::string::npos) {
    output.replace(position, find.size(), replace);
    position = output.find(find, position + replace.size());
  }
  return output;
}
}  // namespace rcpputils
