# SPDX-License-Identifier: Apache-2.0
"""Plugin descriptions of pluginlib."""

from __future__ import annotations

from rosward.source.plugin_files import PluginClass, read_plugins


def test_classes_with_their_libraries() -> None:
    text = b"""<class_libraries>
      <library path="lib/libshapes"><class name="demo/Square" type="demo::Square" base_class_type="demo::Shape"/></library>
      <library path="more"><class type="::demo::Circle" base_class_type="demo::Shape"><description>round</description></class></library>
    </class_libraries>"""
    assert read_plugins(text, "plugins.xml") == (
        (
            PluginClass("demo/Square", "demo::Square", "demo::Shape", "shapes"),
            PluginClass("demo::Circle", "demo::Circle", "demo::Shape", "more"),
        ),
        None,
    )


def test_what_is_no_xml_is_told() -> None:
    found, wrong = read_plugins(b"<library><class type='a'></library>", "plugins.xml")
    assert found == ()
    assert wrong is not None
    assert wrong[0].startswith("plugins.xml is not well-formed")


def test_entities_are_refused() -> None:
    found, wrong = read_plugins(b'<!DOCTYPE x [<!ENTITY a "b">]><library/>', "plugins.xml")
    assert found == ()
    assert wrong is not None
