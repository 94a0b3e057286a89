# SPDX-License-Identifier: Apache-2.0
"""base64: values as text."""

from _rosward import pure

pure(__name__)
