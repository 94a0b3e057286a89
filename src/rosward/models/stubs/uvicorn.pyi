# SPDX-License-Identifier: Apache-2.0
"""uvicorn: an application runs until the program ends. Read from uvicorn 0.34."""
from _rosward import escape, spin

def run(app, **kwargs):
    _runs(app)
def _runs(app):
    if isinstance(app, str):  # what it names is imported
        escape(app)
    spin()

class Config:
    def __init__(self, app, *args, **kwargs):
        self.app = app
class Server:
    def __init__(self, config):
        self.config = config
        self.should_exit = False
    def run(self, sockets=None):
        _runs(self.config.app)
    async def serve(self, sockets=None):
        _runs(self.config.app)
