# SPDX-License-Identifier: Apache-2.0
"""The HTML report: what does the document say that it holds (`document.py`), and how does it become one file (`page.py`)?

The document is plain JSON under a schema; the scripts in `assets/` read nothing else.
"""
