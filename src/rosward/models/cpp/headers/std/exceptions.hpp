// SPDX-License-Identifier: Apache-2.0
// std: the exceptions of the standard library, which programs derive from, throw and catch.

namespace std
{
class exception
{
public:
  exception() {}
  virtual ~exception() {}
  virtual const char * what() const noexcept {return "std::exception";}
};
class bad_alloc : public exception
{
public:
  bad_alloc() {}
  const char * what() const noexcept override {return "std::bad_alloc";}
};
class bad_cast : public exception
{
public:
  bad_cast() {}
  const char * what() const noexcept override {return "std::bad_cast";}
};
class bad_typeid : public exception
{
public:
  bad_typeid() {}
  const char * what() const noexcept override {return "std::bad_typeid";}
};
class bad_exception : public exception
{
public:
  bad_exception() {}
  const char * what() const noexcept override {return "std::bad_exception";}
};
class bad_function_call : public exception
{
public:
  bad_function_call() {}
  const char * what() const noexcept override {return "std::bad_function_call";}
};
class bad_weak_ptr : public exception
{
public:
  bad_weak_ptr() {}
  const char * what() const noexcept override {return "std::bad_weak_ptr";}
};
class bad_optional_access : public exception
{
public:
  bad_optional_access() {}
  const char * what() const noexcept override {return "std::bad_optional_access";}
};
class bad_variant_access : public exception
{
public:
  bad_variant_access() {}
  const char * what() const noexcept override {return "std::bad_variant_access";}
};
class bad_any_cast : public bad_cast
{
public:
  bad_any_cast() {}
  const char * what() const noexcept override {return "std::bad_any_cast";}
};
class logic_error : public exception
{
public:
  explicit logic_error(const std::string & message) : message_(message) {}
  const char * what() const noexcept override {return message_.c_str();}

private:
  std::string message_;
};
class invalid_argument : public logic_error
{
public:
  explicit invalid_argument(const std::string & message) : logic_error(message) {}
};
class domain_error : public logic_error
{
public:
  explicit domain_error(const std::string & message) : logic_error(message) {}
};
class length_error : public logic_error
{
public:
  explicit length_error(const std::string & message) : logic_error(message) {}
};
class out_of_range : public logic_error
{
public:
  explicit out_of_range(const std::string & message) : logic_error(message) {}
};
class future_error : public logic_error
{
public:
  explicit future_error(const std::string & message) : logic_error(message) {}
};
class runtime_error : public exception
{
public:
  explicit runtime_error(const std::string & message) : message_(message) {}
  const char * what() const noexcept override {return message_.c_str();}

private:
  std::string message_;
};
class range_error : public runtime_error
{
public:
  explicit range_error(const std::string & message) : runtime_error(message) {}
};
class overflow_error : public runtime_error
{
public:
  explicit overflow_error(const std::string & message) : runtime_error(message) {}
};
class underflow_error : public runtime_error
{
public:
  explicit underflow_error(const std::string & message) : runtime_error(message) {}
};
class regex_error : public runtime_error
{
public:
  explicit regex_error(const std::string & message) : runtime_error(message) {}
};
class system_error : public runtime_error
{
public:
  template<typename CodeT>
  system_error(const CodeT & code, const std::string & message) : runtime_error(message) {}
  template<typename CodeT>
  explicit system_error(const CodeT & code) : runtime_error(rosward::unknown("live", "std::system_error", "str")) {}
  std::error_code code() const;
};
namespace filesystem
{
class filesystem_error : public std::system_error
{
public:
  template<typename ... Args>
  filesystem_error(const std::string & message, const Args & ... more) : std::system_error(0, message) {}
};
}  // namespace filesystem
}  // namespace std
