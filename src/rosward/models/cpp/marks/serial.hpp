// SPDX-License-Identifier: Apache-2.0
// Serial ports: serial, and libserial.

namespace serial
{
class Serial
{
public:
  [[rosward::sink("device")]] size_t write();
  [[rosward::source("device"), rosward::changes]] size_t read();
  [[rosward::source("device"), rosward::changes]] size_t readline();
};
}
namespace LibSerial
{
class SerialPort
{
public:
  [[rosward::sink("device")]] void Write();
  [[rosward::source("device"), rosward::changes]] void Read();
  [[rosward::source("device"), rosward::changes]] void ReadLine();
};
}
