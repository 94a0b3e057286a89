// SPDX-License-Identifier: Apache-2.0
// Of a library: linked where a program has no `main` of its own.
namespace rosward_double
{
int run_components(int argc, char ** argv);
}

int main(int argc, char ** argv) { return rosward_double::run_components(argc, argv); }
