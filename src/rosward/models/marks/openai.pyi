# SPDX-License-Identifier: Apache-2.0
"""openai: the service of OpenAI, over the network."""

from _rosward import sink, source

sink("network", __name__)
source("network", __name__)
