# SPDX-License-Identifier: Apache-2.0
"""Which functions are those of C, of POSIX and of Linux? They write to what they get a pointer to, and throw nothing.

memset(buffer, 0, sizeof(buffer));
read(port, buffer, 64);
"""

from __future__ import annotations

from typing import Final

__all__ = ["C_FUNCTIONS"]

C_FUNCTIONS: Final = frozenset(
    {
        "memset", "memcpy", "memmove", "memcmp", "memchr", "memccpy", "mempcpy", "bzero", "bcopy", "strcoll", "strxfrm", "strpbrk",
        "strspn", "strcspn", "strtok", "strtok_r", "stpcpy", "stpncpy", "strnlen", "strndup", "strsignal", "strsep", "strlcpy",
        "strlcat", "malloc", "calloc", "realloc", "aligned_alloc", "posix_memalign", "qsort", "bsearch", "div", "ldiv", "rand_r",
        "drand48", "lrand48", "srand48", "mblen", "setenv", "unsetenv", "putenv", "realpath", "mkstemp", "mktemp", "mkdtemp",
        "getloadavg", "fopen", "fdopen", "freopen", "fclose", "fread", "fwrite", "fgets", "fgetc", "getc", "getchar", "fputc",
        "putc", "ungetc", "fseek", "ftell", "rewind", "feof", "ferror", "clearerr", "fileno", "fscanf", "scanf", "sscanf",
        "vfprintf", "vprintf", "dprintf", "remove", "rename", "tmpfile", "tmpnam", "pclose", "setbuf", "getdelim", "clock",
        "difftime", "mktime", "gmtime", "gmtime_r", "localtime", "localtime_r", "asctime", "asctime_r", "ctime", "ctime_r",
        "strftime", "strptime", "gettimeofday", "settimeofday", "clock_gettime", "clock_getres", "clock_settime", "clock_nanosleep",
        "timespec_get", "timer_create", "timer_settime", "timer_delete", "open", "openat", "creat", "close", "read", "write",
        "pread", "pwrite", "readv", "writev", "lseek", "dup", "dup2", "pipe", "fsync", "ftruncate", "truncate", "fcntl", "ioctl",
        "poll", "ppoll", "select", "pselect", "epoll_create", "epoll_create1", "epoll_ctl", "epoll_wait", "eventfd",
        "timerfd_create", "timerfd_settime", "inotify_init", "inotify_add_watch", "isatty", "ttyname", "access", "stat", "fstat",
        "lstat", "mkdir", "rmdir", "unlink", "link", "symlink", "readlink", "chmod", "chown", "opendir", "readdir", "closedir",
        "scandir", "getcwd", "chdir", "mmap", "munmap", "msync", "mlock", "mlockall", "munlock", "munlockall", "shm_open",
        "shm_unlink", "sysconf", "getpagesize", "getpid", "getppid", "getuid", "geteuid", "getgid", "getegid", "gethostname",
        "sethostname", "uname", "getlogin", "getpwuid", "getpwnam", "getrlimit", "setrlimit", "fork", "vfork", "execv", "execvp",
        "execve", "execle", "wait", "waitpid", "kill", "alarm", "pause", "nice", "setpriority", "getpriority", "sigaction",
        "sigemptyset", "sigfillset", "sigaddset", "sigdelset", "sigprocmask", "sigwait", "sched_setscheduler", "sched_getscheduler",
        "sched_setaffinity", "sched_getaffinity", "sched_get_priority_max", "sched_get_priority_min", "sched_yield",
        "pthread_detach", "pthread_self", "pthread_cancel", "pthread_exit", "pthread_setname_np", "pthread_getname_np",
        "pthread_setschedparam", "pthread_getschedparam", "pthread_setaffinity_np", "pthread_attr_init", "pthread_attr_destroy",
        "pthread_mutex_init", "pthread_mutex_destroy", "pthread_mutex_lock", "pthread_mutex_trylock", "pthread_mutex_unlock",
        "pthread_cond_init", "pthread_cond_destroy", "pthread_cond_signal", "pthread_cond_broadcast",
        "sem_init", "sem_destroy", "sem_open", "sem_close", "sem_trywait", "sem_post", "socket", "socketpair", "bind",
        "connect", "listen", "accept", "accept4", "shutdown", "send", "sendto", "sendmsg", "recv", "recvfrom", "recvmsg",
        "getsockopt", "setsockopt", "getsockname", "getpeername", "getaddrinfo", "freeaddrinfo", "getnameinfo", "gethostbyname",
        "gai_strerror", "inet_addr", "inet_aton", "inet_ntoa", "inet_ntop", "inet_pton", "htons", "htonl", "ntohs", "ntohl",
        "htole16", "htole32", "htobe16", "htobe32", "le16toh", "le32toh", "be16toh", "be32toh", "if_nametoindex", "getifaddrs",
        "freeifaddrs", "tcgetattr", "tcsetattr", "tcflush", "tcdrain", "tcsendbreak", "cfmakeraw", "cfsetispeed", "cfsetospeed",
        "cfgetispeed", "cfgetospeed", "cfsetspeed", "openlog", "syslog", "closelog", "uuid_generate", "uuid_generate_random",
        "uuid_generate_time", "uuid_unparse", "uuid_unparse_lower", "uuid_unparse_upper", "uuid_parse", "uuid_clear",
        "uuid_compare", "uuid_copy", "uuid_is_null", "isblank", "iscntrl", "isgraph", "exp2", "exp2f", "expm1", "expm1f", "log1p",
        "log1pf", "logb", "logbf", "ilogb", "scalbn", "scalbln", "frexp", "frexpf", "modf", "modff", "asinh", "asinhf", "acosh",
        "acoshf", "atanh", "atanhf", "erf", "erff", "erfc", "erfcf", "tgamma", "tgammaf", "lgamma", "lgammaf", "nextafter",
        "nextafterf", "nexttoward", "remquo", "sincos", "sincosf", "j0", "j1", "jn", "y0", "y1", "yn",
    }
)  # fmt: skip
