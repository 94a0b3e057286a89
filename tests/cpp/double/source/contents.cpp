// SPDX-License-Identifier: Apache-2.0
// The contents of what arrives, as the environment says.
#include "rosward_double/contents.hpp"

#include <cstdlib>

namespace rosward_double
{
namespace
{
const char * varied()
{
  static const char * const found = std::getenv("ROSWARD_DOUBLE_VARY");
  return found;
}

// Which of the contents of a source this run has.
uint64_t variant(const std::string & source)
{
  std::istringstream words(varied());
  std::string word;
  while (words >> word) {
    const size_t at = word.find('=');
    if (word.substr(0, at) == source) {
      return std::stoull(word.substr(at + 1));
    }
  }
  return 0;
}

// FNV-1a
uint64_t mixed(uint64_t state, const std::string & text)
{
  for (const unsigned char c : text) {
    state = (state ^ c) * 1099511628211ull;
  }
  return state;
}
}  // namespace

bool observed() { return varied() != nullptr; }

void said(const std::string & sink, const std::string & content) { log("said " + sink + " " + content); }

Contents::Contents(const std::string & source, int turn)
: state_(mixed(14695981039346656037ull, source + " " + std::to_string(turn) + " " + std::to_string(variant(source))))
{
  log("comes " + source);
}

int64_t Contents::choose(int64_t most)
{
  // splitmix64
  uint64_t z = state_ += 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<int64_t>((z ^ (z >> 31)) % static_cast<uint64_t>(most));
}

double Contents::number()
{
  static const double numbers[] = {-3.0, -1.0, 0.0, 0.5, 1.0, 2.0, 4.0, 7.5, 20.0};
  return numbers[choose(9)];
}

std::string Contents::text()
{
  static const char * const texts[] = {"a", "b", "go", "stop", "left", "7", "2.5", "red"};
  return texts[choose(8)];
}
}  // namespace rosward_double
