# SPDX-License-Identifier: Apache-2.0
"""SpeechRecognition: what microphones hear, and services that write it down."""

from _rosward import changes, hands, pure, sink, source

@source("device")
class Microphone: ...

@source("file")
class AudioFile: ...

@pure
class Recognizer:
    """What it listens to says where that comes from."""
    @changes("self")
    def adjust_for_ambient_noise(self, source, duration=1): ...
    @hands("speech_recognition.Recognizer")
    def listen_in_background(self, source, callback, phrase_time_limit=None): ...
    @sink("network")
    @source("network")
    def recognize_amazon(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_assemblyai(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_azure(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_cohere_api(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_google(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_google_cloud(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_groq(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_houndify(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_ibm(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_lex(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_openai(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_whisper_api(self, audio_data, *args, **kwargs): ...
    @sink("network")
    @source("network")
    def recognize_wit(self, audio_data, *args, **kwargs): ...
