// SPDX-License-Identifier: Apache-2.0
// OpenCV: files, cameras.

namespace cv
{
[[rosward::sink("file")]] bool imwrite();
[[rosward::source("file")]] Mat imread();
class [[rosward::source("device")]] VideoCapture
{
public:
  [[rosward::source("device"), rosward::changes]] bool read();
  [[rosward::source("device"), rosward::changes]] bool retrieve();
};
class VideoWriter
{
public:
  [[rosward::sink("file")]] void write();
  [[rosward::sink("file")]] VideoWriter & operator<<();
};
}
