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
[[rosward::changes]] auto memcpy();
[[rosward::changes]] auto memmove();
[[rosward::changes]] auto memset();
[[rosward::changes]] auto memccpy();
[[rosward::changes]] auto mempcpy();
[[rosward::changes]] auto strcpy();
[[rosward::changes]] auto strncpy();
[[rosward::changes]] auto strcat();
[[rosward::changes]] auto strncat();
[[rosward::changes]] auto strtok();
[[rosward::changes]] auto strxfrm();
[[rosward::changes]] auto strftime();
[[rosward::changes]] auto snprintf();
[[rosward::changes]] auto sprintf();
[[rosward::changes]] auto vsnprintf();
[[rosward::changes]] auto vsprintf();
[[rosward::changes]] auto sscanf();
[[rosward::changes]] auto vsscanf();
[[rosward::changes]] auto qsort();
[[rosward::changes]] auto modf();
[[rosward::changes]] auto modff();
[[rosward::changes]] auto frexp();
[[rosward::changes]] auto frexpf();
[[rosward::changes]] auto remquo();
[[rosward::changes]] auto strtol();
[[rosward::changes]] auto strtoll();
[[rosward::changes]] auto strtoul();
[[rosward::changes]] auto strtoull();
[[rosward::changes]] auto strtod();
[[rosward::changes]] auto strtof();
[[rosward::changes]] auto strtold();
[[rosward::changes]] auto from_chars();
[[rosward::changes]] auto to_chars();
[[rosward::changes]] auto set_union();
[[rosward::changes]] auto set_intersection();
[[rosward::changes]] auto set_difference();
[[rosward::changes]] auto set_symmetric_difference();
[[rosward::changes]] auto merge();
[[rosward::changes]] auto inplace_merge();
[[rosward::changes]] auto partial_sort();
[[rosward::changes]] auto partial_sort_copy();
[[rosward::changes]] auto rotate_copy();
[[rosward::changes]] auto remove_copy();
[[rosward::changes]] auto remove_copy_if();
[[rosward::changes]] auto replace_copy();
[[rosward::changes]] auto replace_copy_if();
[[rosward::changes]] auto reverse_copy();
[[rosward::changes]] auto unique_copy();
[[rosward::changes]] auto partition_copy();
[[rosward::changes]] auto stable_partition();
[[rosward::changes]] auto sample();
[[rosward::changes]] auto shuffle();
[[rosward::changes]] auto random_shuffle();
[[rosward::changes]] auto exclusive_scan();
[[rosward::changes]] auto inclusive_scan();
[[rosward::changes]] auto transform_exclusive_scan();
[[rosward::changes]] auto transform_inclusive_scan();
[[rosward::changes]] auto generate_n();
[[rosward::changes]] auto for_each_n();
[[rosward::changes]] auto swap_ranges();
[[rosward::changes]] auto move_backward();
[[rosward::changes]] auto copy_backward();
[[rosward::changes]] auto next_permutation();
[[rosward::changes]] auto prev_permutation();
[[rosward::changes]] auto make_heap();
[[rosward::changes]] auto sort_heap();
[[rosward::changes]] auto push_heap();
[[rosward::changes]] auto pop_heap();
[[rosward::changes]] auto nth_element();
[[rosward::changes]] auto uninitialized_copy();
[[rosward::changes]] auto uninitialized_copy_n();
[[rosward::changes]] auto uninitialized_fill();
[[rosward::changes]] auto uninitialized_move();
[[rosward::changes]] auto construct_at();
[[rosward::changes]] auto atomic_store();
[[rosward::changes]] auto atomic_exchange();
[[rosward::changes]] auto atomic_compare_exchange_strong();
[[rosward::changes]] auto atomic_compare_exchange_weak();
[[rosward::changes]] auto atomic_fetch_add();
[[rosward::changes]] auto atomic_fetch_sub();
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
[[rosward::source("stdin")]] int getchar();
namespace cin
{
[[rosward::source("stdin")]] auto get();
}
}
