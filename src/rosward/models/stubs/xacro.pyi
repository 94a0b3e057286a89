# SPDX-License-Identifier: Apache-2.0
"""xacro: XML that a macro language makes; nothing of ROS is in it but the text of a robot description.

Read from xacro 2.0.
"""

from _rosward import changes, unknown


class _Document:
    """What `xml.dom` has read."""

    def toxml(self, *args, **kwargs): return unknown("file", "robot description", "str")
    def toprettyxml(self, *args, **kwargs): return unknown("file", "robot description", "str")


class XacroException(Exception): ...


def parse(inp, filename=None): return _Document()
@changes("doc")
def process_doc(doc, **kwargs) -> None: ...
def process_file(input_file_name, **kwargs): return _Document()
def process(input_file_name, just_includes=False, *args, **kwargs): return unknown("file", "robot description", "str")
