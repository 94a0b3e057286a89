# SPDX-License-Identifier: Apache-2.0
"""`getopt`: any number of the options named."""
from _rosward import native

class GetoptError(Exception):
    opt = ''
    msg = ''
error = GetoptError

@native
def getopt(args, shortopts, longopts=[]): ...
@native
def gnu_getopt(args, shortopts, longopts=[]): ...
