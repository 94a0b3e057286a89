// SPDX-License-Identifier: Apache-2.0
// OpenCV: files.

namespace cv
{
[[rosward::sink("file")]] bool imwrite();
[[rosward::source("file")]] Mat imread();
}
