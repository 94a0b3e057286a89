# SPDX-License-Identifier: Apache-2.0
"""`logging`: harmless, but for handlers that the program writes."""
from _rosward import ask, escape, raises_nothing, reads_only, schedule, sink, unknown

reads_only(__name__)
raises_nothing(__name__)

NOTSET = 0
DEBUG = 10
INFO = 20
WARN = 30
WARNING = 30
ERROR = 40
CRITICAL = 50
FATAL = 50

class Filterer:
    def addFilter(self, filter):
        schedule(filter if callable(filter) else filter.filter, LogRecord(), event='log')
    def removeFilter(self, filter) -> None: ...
    def filter(self, record) -> bool: ...

class LogRecord:
    """Not followed."""
    def __init__(self, name=None, level=None, pathname=None, lineno=None, msg=None, args=None, exc_info=None,
                 func=None, sinfo=None, **kwargs): ...

class Formatter:
    def __init__(self, fmt=None, datefmt=None, style='%', validate=True, *, defaults=None): ...
    def format(self, record) -> str: ...
    def formatTime(self, record, datefmt=None) -> str: ...
    def formatException(self, ei) -> str: ...
class Filter:
    def __init__(self, name=''):
        self.name = name
    def filter(self, record) -> bool: ...

class Handler(Filterer):
    def __init__(self, level=NOTSET):
        self.level = level
        self.formatter = None
        self.lock = None
    def setLevel(self, level) -> None: ...
    def setFormatter(self, fmt):
        self.formatter = fmt
    def format(self, record) -> str: ...
    def emit(self, record) -> None: ...
    def handle(self, record) -> bool: ...
    def handleError(self, record) -> None: ...
    def acquire(self) -> None: ...
    def release(self) -> None: ...
    def flush(self) -> None: ...
    def close(self) -> None: ...
    def get_name(self) -> str: ...
    def set_name(self, name) -> None: ...
class StreamHandler(Handler):
    def __init__(self, stream=None):
        super().__init__()
        self.stream = stream
        if stream is not None:
            schedule(ask, stream, 'write', unknown('call', 'text that a library writes', 'str'), event='log')
class FileHandler(StreamHandler):
    def __init__(self, filename, mode='a', encoding=None, delay=False, errors=None):
        super().__init__()
        self.baseFilename = filename
class NullHandler(Handler): ...

class Logger(Filterer):
    def __init__(self, name, level=NOTSET):
        self.name = name
        self.level = level
        self.handlers = []
        self.propagate = True
        self.disabled = False
    def setLevel(self, level) -> None: ...
    @sink("stdout", "file")
    def debug(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def info(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def warning(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def warn(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def error(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def exception(self, msg, *args, exc_info=True, **kwargs) -> None: ...
    @sink("stdout", "file")
    def critical(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def fatal(self, msg, *args, **kwargs) -> None: ...
    @sink("stdout", "file")
    def log(self, level, msg, *args, **kwargs) -> None: ...
    def addHandler(self, hdlr):
        schedule(hdlr.emit, LogRecord(), event='log')
    def removeHandler(self, hdlr) -> None: ...
    def hasHandlers(self) -> bool: ...
    def isEnabledFor(self, level) -> bool: ...
    def getEffectiveLevel(self) -> int: ...
    def getChild(self, suffix):
        return Logger(self.name + '.' + suffix)
    def handle(self, record) -> None: ...
class LoggerAdapter(Logger):
    def __init__(self, logger, extra=None):
        self.logger = logger
        self.extra = extra
    def process(self, msg, kwargs):
        return msg, {**kwargs, 'extra': self.extra}
    def log(self, level, msg, *args, **kwargs):
        if self.isEnabledFor(level):
            msg, kwargs = self.process(msg, kwargs)
            self.logger.log(level, msg, *args, **kwargs)
    def debug(self, msg, *args, **kwargs):
        self.log(DEBUG, msg, *args, **kwargs)
    def info(self, msg, *args, **kwargs):
        self.log(INFO, msg, *args, **kwargs)
    def warning(self, msg, *args, **kwargs):
        self.log(WARNING, msg, *args, **kwargs)
    def warn(self, msg, *args, **kwargs):
        self.log(WARNING, msg, *args, **kwargs)
    def error(self, msg, *args, **kwargs):
        self.log(ERROR, msg, *args, **kwargs)
    def exception(self, msg, *args, exc_info=True, **kwargs):
        self.log(ERROR, msg, *args, **{**kwargs, 'exc_info': exc_info})
    def critical(self, msg, *args, **kwargs):
        self.log(CRITICAL, msg, *args, **kwargs)

root = Logger('root')
raiseExceptions = True

def getLogger(name=None):
    return root if name is None else Logger(name)
def basicConfig(**kwargs):
    stream = kwargs.get('stream')
    if stream is not None:
        StreamHandler(stream)
    for handler in kwargs.get('handlers') or ():
        root.addHandler(handler)
def captureWarnings(capture) -> None: ...
def disable(level=CRITICAL) -> None: ...
def shutdown(handlerList=None) -> None: ...
def addLevelName(level, levelName) -> None: ...
def getLevelName(level): ...
def getLogRecordFactory():
    return LogRecord
def setLogRecordFactory(factory):
    text = unknown('call', 'what is logged', 'str')
    schedule(factory, text, unknown('call', 'level', 'int'), text, unknown('call', 'line', 'int'), text,
             unknown('call', 'arguments of what is logged', 'tuple'), None, text, None, event='log')
def setLoggerClass(klass):
    escape(klass)
def getLoggerClass():
    return Logger
@sink("stdout", "file")
def debug(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def info(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def warning(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def warn(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def error(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def exception(msg, *args, exc_info=True, **kwargs) -> None: ...
@sink("stdout", "file")
def critical(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def fatal(msg, *args, **kwargs) -> None: ...
@sink("stdout", "file")
def log(level, msg, *args, **kwargs) -> None: ...
