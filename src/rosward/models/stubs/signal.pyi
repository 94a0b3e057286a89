# SPDX-License-Identifier: Apache-2.0
"""`signal`: a handler may run at any time."""
from _rosward import reads_only, schedule, spins, unknown

reads_only(__name__)

SIG_DFL = 0
SIG_IGN = 1
SIG_BLOCK = 0
SIG_UNBLOCK = 1
SIGHUP = 1
SIGINT = 2
SIGQUIT = 3
SIGABRT = 6
SIGKILL = 9
SIGUSR1 = 10
SIGSEGV = 11
SIGUSR2 = 12
SIGPIPE = 13
SIGALRM = 14
SIGTERM = 15
SIGCHLD = 17
SIGCONT = 18
SIGSTOP = 19
SIGTSTP = 20
ITIMER_REAL = 0

class Signals(int): ...

def default_int_handler(signalnum, frame, /):
    raise KeyboardInterrupt
def signal(signalnum, handler):
    if callable(handler):
        schedule(handler, signalnum, unknown('live', 'frame of a signal'), event='signal')
    return SIG_DFL
def getsignal(signalnum): ...
@spins
def pause() -> None: ...
def alarm(seconds, /) -> int: ...
def setitimer(which, seconds, interval=0.0, /): ...
def siginterrupt(signalnum, flag) -> None: ...
def pthread_sigmask(how, mask): ...
@spins
def raise_signal(signalnum, /) -> None: ...
def set_wakeup_fd(fd, /, *, warn_on_full_buffer=True) -> int: ...
