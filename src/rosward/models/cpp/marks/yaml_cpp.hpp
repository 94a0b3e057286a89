// SPDX-License-Identifier: Apache-2.0
// yaml-cpp: files.

namespace YAML
{
[[rosward::source("file")]] Node LoadFile();
}
