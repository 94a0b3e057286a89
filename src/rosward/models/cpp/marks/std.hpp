// SPDX-License-Identifier: Apache-2.0
// The standard library: its models are in code, so that no header of the models declares them.

namespace [[rosward::pure]] std
{
class ofstream
{
  [[rosward::sink("file")]] auto write();
  [[rosward::sink("file")]] auto put();
};
class ifstream
{
  [[rosward::source("file"), rosward::changes]] auto read();
  [[rosward::source("file"), rosward::changes]] auto readsome();
  [[rosward::source("file"), rosward::changes]] auto get();
  [[rosward::source("file"), rosward::changes]] auto getline();
};
[[rosward::source("stdin"), rosward::changes]] int scanf();
[[rosward::source("file"), rosward::changes]] int fscanf();
[[rosward::sink("file")]] int fputc();
[[rosward::sink("stdout")]] int printf();
[[rosward::sink("stdout")]] int puts();
[[rosward::sink("stdout")]] int putchar();
[[rosward::sink("file")]] int fprintf();
[[rosward::sink("file")]] int fputs();
[[rosward::sink("file")]] size_t fwrite();
[[rosward::sink("file")]] int remove();
[[rosward::sink("file")]] int rename();
namespace [[rosward::sink("file")]] filesystem {}
[[rosward::source("file"), rosward::changes]] size_t fread();
[[rosward::source("file"), rosward::changes]] char * fgets();
[[rosward::sink("process"), rosward::source("process")]] int system();
[[rosward::sink("process"), rosward::source("process")]] FILE * popen();
[[rosward::sink("process")]] int execl();
[[rosward::sink("process")]] int execlp();
[[rosward::source("clock")]] time_t time();
[[rosward::source("clock")]] clock_t clock();
namespace chrono
{
class steady_clock {[[rosward::source("clock")]] static auto now();};
class system_clock {[[rosward::source("clock")]] static auto now();};
class high_resolution_clock {[[rosward::source("clock")]] static auto now();};
}
[[rosward::source("random")]] int rand();
[[rosward::source("random")]] int random();
class [[rosward::source("random")]] random_device {};
[[rosward::source("env")]] char * getenv();
[[rosward::source("env")]] char * secure_getenv();
[[rosward::source("stdin")]] auto getline();
[[rosward::source("stdin")]] int getchar();
namespace cin
{
[[rosward::source("stdin")]] auto get();
}
}
