# SPDX-License-Identifier: Apache-2.0
"""SpeechRecognition: what microphones hear, and services that write it down."""

from _rosward import sink, source

class Recognizer:
    @source("device")
    def listen(self, source, timeout=None, phrase_time_limit=None, *args): ...
    @source("device")
    def listen_in_background(self, source, callback, phrase_time_limit=None): ...
    @source("device")
    def record(self, source, duration=None, offset=None): ...
    @sink("network")
    @source("network")
    def recognize_google(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_google_cloud(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_azure(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_wit(self, audio_data, *args, **kwargs): ...
