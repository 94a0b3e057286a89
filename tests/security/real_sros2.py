# SPDX-License-Identifier: Apache-2.0
"""Runs the code of the real sros2 on policies, where somebody has it: its command line and its ROS are faked, its
reading, merging, sorting, validating and translating are its own.

    python real_sros2.py SROS2_FOLDER  <  [["<policy …", [[ns, node, enclave, kind, way, name], …]], …]
      ->  [["<policy …", {"/talker": [["write", "rt/chatter"], …]}], …]    the merged policies, and their permissions
"""

from __future__ import annotations

import importlib
import io
import json
import os
import sys
import tempfile
import types
from pathlib import Path
from typing import Any


def _fake(name: str, **members: object) -> None:
    module = types.ModuleType(name)
    vars(module).update(members)
    sys.modules[name] = module


def _without_its_surroundings(folder: str) -> None:
    """Nothing of ROS, of its command line and of its keystore; the schema of `xml:base` comes from its own cache."""
    for name in ("argcomplete", "ros2cli", "ros2cli.node"):
        _fake(name)
    _fake("argcomplete.completers", FilesCompleter=object)
    _fake("ros2cli.node.strategy", add_arguments=print, NodeStrategy=object)
    _fake("ros2cli.plugin_system", PLUGIN_SYSTEM_VERSION="0.1", satisfies_version=print)
    _fake("sros2", __path__=[f"{folder}/sros2"])
    _fake("sros2.api", __path__=[f"{folder}/sros2/api"])
    os.environ["XML_CATALOG_FILES"] = f"{folder}/xml_cache/xhtml-cache.xml"


def _rights(policy: Any) -> dict[str, list[list[str]]]:
    """What `create_permission` writes for each enclave, which is one after another by the first of its name."""
    etree = importlib.import_module("lxml.etree")
    ours = importlib.import_module("sros2.policy")
    select = importlib.import_module("sros2.api._policy").get_policy_from_tree
    translate = etree.XSLT(etree.parse(str(ours.get_transport_template("dds", "permissions.xsl"))))
    schema = etree.XMLSchema(etree.parse(str(ours.get_transport_schema("dds", "permissions.xsd"))))
    found: dict[str, list[list[str]]] = {}
    for path in [enclave.get("path") for enclave in policy.iter("enclave")]:
        again = etree.ElementTree(etree.fromstring(etree.tostring(policy)))
        document = translate(select(path, again), allow_ros_discovery_topic=etree.XSLT.strparam("1"))
        schema.assertValid(document)
        grant = document.find("permissions/grant")
        found[path] = [
            [way, topic.text]
            for way, element in (("write", "publish"), ("read", "subscribe"))
            for topic in grant.iterfind(f"allow_rule/{element}/topics/topic")
        ]
    return found


def _answer(given: str, graph: list[list[str]]) -> tuple[str, dict[str, list[list[str]]]]:
    generate = importlib.import_module("sros2.verb.generate_policy")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "policy.xml"
        file.write_text(given, encoding="utf-8")
        verb = generate.GeneratePolicyVerb.__new__(generate.GeneratePolicyVerb)
        policy = verb.get_policy(file)
        for namespace, node, enclave, kind, way, name in graph:
            fqn = namespace.rstrip("/") + "/" + node
            who = generate._NodeName(node=node, ns=namespace, fqn=fqn, path=enclave)
            profile = verb.get_profile(policy, who)
            verb.add_permission(profile, kind, way, "ALLOW", [generate._TopicInfo(fqn=name, type=[])], who)
        stream = io.StringIO()
        importlib.import_module("sros2.policy").dump_policy(policy, stream)
        file.write_text(stream.getvalue(), encoding="utf-8")
        return stream.getvalue(), _rights(verb.get_policy(file))


if __name__ == "__main__":
    _without_its_surroundings(sys.argv[1])
    print(json.dumps([_answer(*each) for each in json.load(sys.stdin)]))
