// SPDX-License-Identifier: Apache-2.0
#include "rosward_double/many.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "rosward_double/core.hpp"

namespace rosward_double
{
namespace
{
constexpr unsigned SECONDS = 10;
}

int run_many(const std::vector<Program> & programs, int argc, char ** argv)
{
  for (const auto program : programs) {
    log("begin");
    const pid_t child = fork();
    if (child == 0) {
      alarm(SECONDS);
      program(argc, argv);
      settle();
      _exit(0);  // what a main without `return` gives is no status
    }
    int status = 0;
    waitpid(child, &status, 0);
    log("end " + std::to_string(status));
  }
  return 0;
}
}  // namespace rosward_double
