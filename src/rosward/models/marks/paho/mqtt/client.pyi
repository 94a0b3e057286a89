# SPDX-License-Identifier: Apache-2.0
"""paho.mqtt.client."""

from _rosward import sink

class Client:
    @sink("network")
    def publish(self, topic, payload=None, qos=0, retain=False, properties=None): ...
