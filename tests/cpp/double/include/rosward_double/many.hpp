// SPDX-License-Identifier: Apache-2.0
// Several programs in one binary: each runs in a process of its own.
#pragma once

#include <vector>

namespace rosward_double
{
using Program = int (*)(int, char **);
int run_many(const std::vector<Program> & programs, int argc, char ** argv);
}  // namespace rosward_double
