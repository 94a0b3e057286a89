# SPDX-License-Identifier: Apache-2.0
"""google.cloud: the services of Google, over the network."""

from _rosward import sink, source

sink("network", __name__)
source("network", __name__)
