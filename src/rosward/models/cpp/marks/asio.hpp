// SPDX-License-Identifier: Apache-2.0
// Asio, by itself and in Boost: sockets, serial ports.

namespace asio
{
[[rosward::sink("network")]] size_t write();
[[rosward::sink("network")]] void async_write();
[[rosward::source("network"), rosward::changes]] size_t read();
[[rosward::source("network"), rosward::changes]] size_t read_until();
[[rosward::source("network"), rosward::changes]] void async_read();
[[rosward::source("network"), rosward::changes]] void async_read_until();
namespace ip
{
namespace tcp
{
class socket
{
public:
  [[rosward::sink("network")]] size_t send();
  [[rosward::sink("network")]] size_t write_some();
  [[rosward::sink("network")]] void async_send();
  [[rosward::sink("network")]] void async_write_some();
  [[rosward::source("network"), rosward::changes]] size_t receive();
  [[rosward::source("network"), rosward::changes]] size_t read_some();
  [[rosward::source("network"), rosward::changes]] void async_receive();
  [[rosward::source("network"), rosward::changes]] void async_read_some();
};
}
namespace udp
{
class socket
{
public:
  [[rosward::sink("network")]] size_t send();
  [[rosward::sink("network")]] size_t send_to();
  [[rosward::sink("network")]] void async_send_to();
  [[rosward::source("network"), rosward::changes]] size_t receive();
  [[rosward::source("network"), rosward::changes]] size_t receive_from();
  [[rosward::source("network"), rosward::changes]] void async_receive_from();
};
}
}
class serial_port
{
public:
  [[rosward::sink("device")]] size_t write_some();
  [[rosward::sink("device")]] void async_write_some();
  [[rosward::source("device"), rosward::changes]] size_t read_some();
  [[rosward::source("device"), rosward::changes]] void async_read_some();
};
}
namespace boost
{
namespace asio
{
[[rosward::sink("network")]] size_t write();
[[rosward::sink("network")]] void async_write();
[[rosward::source("network"), rosward::changes]] size_t read();
[[rosward::source("network"), rosward::changes]] size_t read_until();
[[rosward::source("network"), rosward::changes]] void async_read();
[[rosward::source("network"), rosward::changes]] void async_read_until();
namespace ip
{
namespace tcp
{
class socket
{
public:
  [[rosward::sink("network")]] size_t send();
  [[rosward::sink("network")]] size_t write_some();
  [[rosward::sink("network")]] void async_send();
  [[rosward::sink("network")]] void async_write_some();
  [[rosward::source("network"), rosward::changes]] size_t receive();
  [[rosward::source("network"), rosward::changes]] size_t read_some();
  [[rosward::source("network"), rosward::changes]] void async_receive();
  [[rosward::source("network"), rosward::changes]] void async_read_some();
};
}
namespace udp
{
class socket
{
public:
  [[rosward::sink("network")]] size_t send();
  [[rosward::sink("network")]] size_t send_to();
  [[rosward::sink("network")]] void async_send_to();
  [[rosward::source("network"), rosward::changes]] size_t receive();
  [[rosward::source("network"), rosward::changes]] size_t receive_from();
  [[rosward::source("network"), rosward::changes]] void async_receive_from();
};
}
}
class serial_port
{
public:
  [[rosward::sink("device")]] size_t write_some();
  [[rosward::sink("device")]] void async_write_some();
  [[rosward::source("device"), rosward::changes]] size_t read_some();
  [[rosward::source("device"), rosward::changes]] void async_read_some();
};
}
}
