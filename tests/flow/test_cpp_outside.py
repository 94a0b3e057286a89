# SPDX-License-Identifier: Apache-2.0
"""Promise: what a program in C++ writes to files, sockets, devices and terminals leaves there, and what it reads from them comes from there.

Each row is what a callback does with `msg->data` before it publishes `r`, and what else the program declares.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final, NamedTuple

import pytest
from sampling import sample

from .test_cpp import flows
from .test_cpp_ways import PROGRAM

_TO_FILE: Final = ("file", "topic:/in")
_TO_NETWORK: Final = ("network", "topic:/in")
_TO_DEVICE: Final = ("device", "topic:/in")
_TO_TERMINAL: Final = ("stdout", "topic:/in")
_FROM_FILE: Final = ("topic:/out", "file")
_FROM_STDIN: Final = ("topic:/out", "stdin")
_FROM_NETWORK: Final = ("topic:/out", "network")
_FROM_DEVICE: Final = ("topic:/out", "device")
_TCP: Final = "boost::asio::io_context io_; boost::asio::ip::tcp::socket socket_{io_};"
_UDP: Final = _TCP.replace("tcp", "udp") + " boost::asio::ip::udp::endpoint peer_;"
_TEXT: Final = "boost::asio::buffer(std::to_string(msg->data))"


class Case(NamedTuple):
    """What is done, and the output that must hold a source as data."""

    does: str
    expected: tuple[str, str]
    members: str = ""
    before: str = ""


CASES: Final = {
    "write a file": Case('std::ofstream f("x"); f.write(reinterpret_cast<const char *>(&msg->data), 8);', _TO_FILE),
    "put a character": Case("f_.put(static_cast<char>(msg->data));", _TO_FILE, "std::ofstream f_;"),
    "a stream that is passed on": Case(
        "save(f_, msg->data);", _TO_FILE, "std::ofstream f_;", "void save(std::ostream & out, double d) {out << d;}"
    ),
    "fprintf": Case('FILE * f = fopen("x", "w"); fprintf(f, "%f", msg->data);', _TO_FILE),
    "write the terminal": Case("std::cout.write(reinterpret_cast<const char *>(&msg->data), 8);", _TO_TERMINAL),
    "read a file": Case('std::ifstream f("x"); double x; f >> x; r = x;', _FROM_FILE),
    "read a file in a loop": Case('std::ifstream f("x"); double x; while (f >> x) {r += x;}', _FROM_FILE),
    "read the bytes of a file": Case(
        'std::ifstream f("x"); double x; f.read(reinterpret_cast<char *>(&x), sizeof(x)); r = x;', _FROM_FILE
    ),
    "read a line of a file": Case(
        'std::ifstream f("x"); std::string s; std::getline(f, s); r = std::stod(s);', _FROM_FILE
    ),
    "a buffer of a file": Case(
        'std::ifstream f("x"); std::stringstream s; s << f.rdbuf(); r = std::stod(s.str());', _FROM_FILE
    ),
    "read the terminal": Case("double x, y; std::cin >> x >> y; r = y;", _FROM_STDIN),
    "read the terminal into a member": Case("std::cin >> x_; r = x_;", _FROM_STDIN, "double x_;"),
    "scanf": Case('double d; scanf("%lf", &d); r = d;', _FROM_STDIN),
    "send": Case("double d = msg->data; send(fd_, &d, sizeof(d), 0);", _TO_NETWORK, "int fd_ = 0;"),
    "sendto": Case(
        "std::string t = std::to_string(msg->data); ::sendto(fd_, t.c_str(), t.size(), 0, nullptr, 0);",
        _TO_NETWORK,
        "int fd_ = 0;",
    ),
    "recv": Case("double d; recv(fd_, &d, sizeof(d), 0); r = d;", _FROM_NETWORK, "int fd_ = 0;"),
    "recv into an array": Case("char b[8]; ::recv(fd_, b, 8, 0); r = atof(b);", _FROM_NETWORK, "int fd_ = 0;"),
    "how much recvfrom gives": Case(
        "char b[8]; int n = recvfrom(fd_, b, 8, 0, nullptr, nullptr); r = n;", _FROM_NETWORK, "int fd_ = 0;"
    ),
    "read a device": Case("double d; ::read(fd_, &d, 8); r = d;", _FROM_DEVICE, "int fd_ = 0;"),
    "asio write": Case(f"boost::asio::write(socket_, {_TEXT});", _TO_NETWORK, _TCP),
    "asio read": Case(
        "char b[8]; boost::asio::read(socket_, boost::asio::buffer(b)); r = atof(b);", _FROM_NETWORK, _TCP
    ),
    "asio send_to": Case(f"socket_.send_to({_TEXT}, peer_);", _TO_NETWORK, _UDP),
    "asio receive_from": Case(
        "char b[8]; socket_.receive_from(boost::asio::buffer(b), peer_); r = atof(b);", _FROM_NETWORK, _UDP
    ),
    "asio behind a pointer": Case(
        f"socket_->send({_TEXT});",
        _TO_NETWORK,
        "boost::asio::io_context io_; std::unique_ptr<tcp::socket> socket_ = std::make_unique<tcp::socket>(io_);",
        "using boost::asio::ip::tcp;",
    ),
    "a camera": Case("cv::VideoCapture c(0); cv::Mat m; c.read(m); r = m.at<double>(0, 0);", _FROM_DEVICE),
    "a camera that is a member": Case(
        "cv::Mat m; c_ >> m; r = m.at<double>(0, 0);", _FROM_DEVICE, "cv::VideoCapture c_;"
    ),
    "a film": Case("cv::Mat m(1, 1, msg->data); w_ << m;", _TO_FILE, "cv::VideoWriter w_;"),
    "a serial port": Case("s_.write(std::to_string(msg->data));", _TO_DEVICE, 'serial::Serial s_{"x"};'),
    "a recording": Case('w_.write(*msg, "in", now());', _TO_FILE, "rosbag2_cpp::Writer w_;"),
    "a recording behind a pointer": Case(
        'w_ = std::make_unique<rosbag2_cpp::Writer>(); w_->write(*msg, "in", now());',
        _TO_FILE,
        "std::unique_ptr<rosbag2_cpp::Writer> w_;",
    ),
    "a recording that is read": Case(
        'rosbag2_cpp::Reader reader; reader.open("x"); auto b = reader.read_next(); Float64 f;'
        "rclcpp::SerializedMessage s(*b->serialized_data); rclcpp::Serialization<Float64> with;"
        "with.deserialize_message(&s, &f); r = f.data;",
        _FROM_FILE,
    ),
    "a message as bytes and back": Case(
        "rclcpp::SerializedMessage s; rclcpp::Serialization<Float64> with; Float64 f;"
        "with.serialize_message(msg.get(), &s); with.deserialize_message(&s, &f); r = f.data;",
        ("topic:/out", "topic:/in"),
    ),
}


@pytest.mark.parametrize("name", sample(CASES, 2))
def test_it_is_seen(name: str, tmp_path: Path) -> None:
    case = CASES[name]
    program = PROGRAM.replace("@type@", "Float64").replace("@methods@", "")
    for word, text in (("before", case.before), ("on", case.does), ("members", case.members)):
        program = program.replace(f"@{word}@", text)
    path = tmp_path / "main.cpp"
    path.write_text(program)
    sink, source = case.expected
    found = [s for each in flows(path) for s in each.sinks if str(s.sink) == sink]
    assert any(source in map(str, s.data) for s in found)
