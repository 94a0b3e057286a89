# SPDX-License-Identifier: Apache-2.0
"""`rosward serve`: a page on this machine on which sources are analysed. See docs/serve.md."""
