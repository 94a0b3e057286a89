# SPDX-License-Identifier: Apache-2.0
"""Ollama: what is asked goes to a server of models, and its answers come from there."""

from _rosward import sink, source

sink("network", __name__)
source("network", __name__)
