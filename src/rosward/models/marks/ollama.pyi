# SPDX-License-Identifier: Apache-2.0
"""Ollama: what is asked goes to a server of models, and its answers come from there."""

from _rosward import pure, sink, source

@sink("network")
@source("network")
class Client:
    @pure
    def __init__(self, host=None, **kwargs): ...

AsyncClient = Client

@sink("network")
@source("network")
def chat(*args, **kwargs): ...
@sink("network")
@source("network")
def create(*args, **kwargs): ...
@sink("network")
@source("network")
def embed(*args, **kwargs): ...
@sink("network")
@source("network")
def embeddings(*args, **kwargs): ...
@sink("network")
@source("network")
def generate(*args, **kwargs): ...
@sink("network")
@source("network")
def list(*args, **kwargs): ...
@sink("network")
@source("network")
def ps(*args, **kwargs): ...
@sink("network")
@source("network")
def pull(*args, **kwargs): ...
@sink("network")
@source("network")
def push(*args, **kwargs): ...
@sink("network")
@source("network")
def show(*args, **kwargs): ...
@sink("network")
@source("network")
def web_fetch(*args, **kwargs): ...
@sink("network")
@source("network")
def web_search(*args, **kwargs): ...
