# SPDX-License-Identifier: Apache-2.0
"""`subprocess`: what it starts is not followed; ROS programs among it are told."""
from _rosward import native, reads_only, sink, source, unknown

@native
def _launches(command): ...

PIPE = -1
STDOUT = -2
DEVNULL = -3

class SubprocessError(Exception): ...
class CalledProcessError(SubprocessError):
    def __init__(self, returncode, cmd, output=None, stderr=None):
        self.returncode = returncode
        self.cmd = cmd
        self.output = output
        self.stderr = stderr
class TimeoutExpired(SubprocessError):
    def __init__(self, cmd, timeout, output=None, stderr=None):
        self.cmd = cmd
        self.timeout = timeout

@reads_only
class CompletedProcess:
    def __init__(self, args, returncode, stdout=None, stderr=None):
        self.args = args
        self.returncode = returncode
        self.stdout = stdout
        self.stderr = stderr
    def check_returncode(self) -> None: ...

@reads_only
class Popen:
    @sink("process")
    def __init__(self, args, bufsize=-1, executable=None, stdin=None, stdout=None, stderr=None, preexec_fn=None, close_fds=True, shell=False,
                 cwd=None, env=None, universal_newlines=None, startupinfo=None, creationflags=0, restore_signals=True, start_new_session=False,
                 pass_fds=(), *, user=None, group=None, extra_groups=None, encoding=None, errors=None, text=None, umask=-1, pipesize=-1,
                 process_group=None):
        _launches(args)
        self.args = args
        self.pid = unknown('random', 'subprocess.Popen.pid', 'int')
        self.returncode = unknown('input', 'exit status of a program')
        self.stdin = unknown('input', 'subprocess.Popen.stdin')
        self.stdout = unknown('input', 'output of a program')
        self.stderr = unknown('input', 'output of a program')
        if preexec_fn is not None:
            preexec_fn()
    @source("process")
    def poll(self):
        return unknown('input', 'exit status of a program')
    @source("process")
    def wait(self, timeout=None) -> int: ...
    @sink("process")
    @source("process")
    def communicate(self, input=None, timeout=None):
        return (unknown('input', 'output of a program'), unknown('input', 'output of a program'))
    @sink("process")
    def send_signal(self, sig) -> None: ...
    def terminate(self) -> None: ...
    def kill(self) -> None: ...
    def __enter__(self):
        return self
    def __exit__(self, exc_type, value, traceback) -> None: ...

@sink("process")
@source("process")
def run(*popenargs, input=None, capture_output=False, timeout=None, check=False, **kwargs):
    _launches(popenargs[0] if popenargs else kwargs.get('args'))
    return CompletedProcess(popenargs[0] if popenargs else None, unknown('input', 'exit status of a program', 'int'),
                            unknown('input', 'output of a program'), unknown('input', 'output of a program'))
@sink("process")
@source("process")
def call(*popenargs, timeout=None, **kwargs):
    _launches(popenargs[0] if popenargs else kwargs.get('args'))
    return unknown('input', 'exit status of a program', 'int')
@sink("process")
@source("process")
def check_call(*popenargs, **kwargs):
    _launches(popenargs[0] if popenargs else kwargs.get('args'))
    return 0
@sink("process")
@source("process")
def check_output(*popenargs, timeout=None, **kwargs):
    _launches(popenargs[0] if popenargs else kwargs.get('args'))
    return unknown('input', 'output of a program')
@sink("process")
@source("process")
def getoutput(cmd, *, encoding=None, errors=None):
    _launches(cmd)
    return unknown('input', 'output of a program', 'str')
@sink("process")
@source("process")
def getstatusoutput(cmd, *, encoding=None, errors=None):
    _launches(cmd)
    return (unknown('input', 'exit status of a program', 'int'), unknown('input', 'output of a program', 'str'))
@reads_only
def list2cmdline(seq) -> str: ...
