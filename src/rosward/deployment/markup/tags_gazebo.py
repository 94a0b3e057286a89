# SPDX-License-Identifier: Apache-2.0
"""Which action is a tag of the launch extensions of ros_gz_sim and ros_gz_bridge?

    <gz_server world_sdf_file="a.sdf"/>
->  Include(path=($(find-pkg-share ros_gz_sim), '/launch/gz_server.launch.py'), arguments=(('world_sdf_file', 'a.sdf'), …))

Each includes a launch file of its package, with every argument that it knows.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from rosward.deployment.markup.element import Tag
from rosward.deployment.markup.tags_launch import Reader
from rosward.deployment.tree import Include, LaunchAction, Substitution, Template
from rosward.domain.values import Const
from rosward.records import NamedTuple


class _Tag(NamedTuple):
    """The file that a tag includes, the attributes that it needs, and the others with their defaults (None: it is not passed on)."""

    package: str
    file: str
    required: tuple[str, ...]
    optional: tuple[tuple[str, str | None], ...]


_CONTAINER: Final = (
    ("container_name", "ros_gz_container"),
    ("create_own_container", "False"),
    ("use_composition", "False"),
)
_MODEL: Final = (
    *("world", "file", "model_string", "topic", "entity_name", "allow_renaming"),
    *("x", "y", "z", "roll", "pitch", "yaw"),
)
_TAGS: Final = MappingProxyType(
    {
        "gz_server": _Tag(
            "ros_gz_sim", "gz_server", (), (("world_sdf_file", ""), ("world_sdf_string", ""), *_CONTAINER)
        ),
        "gz_spawn_model": _Tag("ros_gz_sim", "gz_spawn_model", (), tuple((name, None) for name in _MODEL)),
        "ros_gz_bridge": _Tag(
            "ros_gz_bridge",
            "ros_gz_bridge",
            ("bridge_name", "config_file"),
            (*_CONTAINER, ("namespace", ""), ("use_respawn", "False"), ("log_level", "info")),
        ),
    }
)


def _include(element: Tag) -> LaunchAction:
    tag = _TAGS[element.tag]
    place = element.place
    arguments: list[tuple[Template, Template]] = [((Const(n),), element.required(n)) for n in tag.required]
    for name, default in tag.optional:
        value = element.template(name)
        if value is not None:
            arguments.append(((Const(name),), value))
        elif default is not None:
            arguments.append(((Const(name),), (Const(default),)))
    share = Substitution("find-pkg-share", ((Const(tag.package),),), place)
    path = (share, Const(f"/launch/{tag.file}.launch.py"))
    return Include(place=place, condition=element.condition(), path=path, format="python", arguments=tuple(arguments))


READERS: Final = MappingProxyType[str, Reader](dict.fromkeys(_TAGS, _include))
