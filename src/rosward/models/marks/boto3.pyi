# SPDX-License-Identifier: Apache-2.0
"""boto3: the services of Amazon, over the network."""

from _rosward import sink, source

sink("network", __name__)
source("network", __name__)
