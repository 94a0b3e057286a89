// SPDX-License-Identifier: Apache-2.0
// C and POSIX: sockets, files, devices, programs.

[[rosward::sink("network")]] ssize_t send();
[[rosward::sink("network")]] ssize_t sendto();
[[rosward::sink("network")]] ssize_t sendmsg();
[[rosward::sink("network")]] ssize_t sendall();
[[rosward::source("network")]] ssize_t recv();
[[rosward::source("network")]] ssize_t recvfrom();
[[rosward::source("network")]] ssize_t recvmsg();
[[rosward::sink("file")]] size_t fwrite();
[[rosward::source("file")]] size_t fread();
[[rosward::source("file")]] [[rosward::source("process")]] char * fgets();
[[rosward::sink("process")]] [[rosward::source("process")]] int system();
[[rosward::sink("process")]] [[rosward::source("process")]] FILE * popen();
[[rosward::sink("process")]] int execv();
[[rosward::sink("process")]] int execvp();
[[rosward::sink("device")]] ssize_t write();
[[rosward::sink("device")]] int ioctl();
[[rosward::sink("device")]] int tcsetattr();
[[rosward::source("device")]] ssize_t read();
[[rosward::sink("device")]] void digitalWrite();
[[rosward::sink("device")]] void softPwmWrite();
[[rosward::sink("device")]] int gpioWrite();
[[rosward::source("device")]] int digitalRead();
[[rosward::source("device")]] int gpioRead();
[[rosward::source("clock")]] int clock_gettime();
[[rosward::source("clock")]] int gettimeofday();
[[rosward::source("random")]] int rand();
[[rosward::source("random")]] double drand48();
[[rosward::source("stdin")]] int getchar();
