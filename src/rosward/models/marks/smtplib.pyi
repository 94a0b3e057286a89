# SPDX-License-Identifier: Apache-2.0
"""`smtplib`: mail."""

from _rosward import sink

sink("network", __name__)
