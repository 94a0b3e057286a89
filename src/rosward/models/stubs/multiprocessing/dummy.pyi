# SPDX-License-Identifier: Apache-2.0
"""`multiprocessing.dummy`: the same names, with threads."""
from multiprocessing import Manager as Manager, Pipe as Pipe, Queue as Queue, Value as Value
from multiprocessing.pool import ThreadPool as _Pool
from threading import Barrier as Barrier, BoundedSemaphore as BoundedSemaphore, Condition as Condition, Event as Event
from threading import Lock as Lock, RLock as RLock, Semaphore as Semaphore, Thread as Process, current_thread as current_process

def Pool(processes=None, initializer=None, initargs=()):
    return _Pool(processes, initializer, initargs)
