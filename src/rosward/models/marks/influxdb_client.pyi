# SPDX-License-Identifier: Apache-2.0
"""influxdb_client: a database, over the network."""

from _rosward import sink, source

sink("network", __name__)
source("network", __name__)
