# SPDX-License-Identifier: Apache-2.0
"""Runs the keystore of the real sros2, where somebody has it: the checks of rclpy are faked, keys, certificates, governance, permissions and
signatures are its own.

    python real_keystore.py SROS2_FOLDER KEYSTORE POLICY_FILE /enclave…
      create_keystore KEYSTORE, then create_enclave and create_permission for each enclave, as the verbs of `ros2 security` do
"""

from __future__ import annotations

import importlib
import os
import sys
import types
from pathlib import Path


def _fake(name: str, **members: object) -> None:
    module = types.ModuleType(name)
    vars(module).update(members)
    sys.modules[name] = module


def _without_rclpy(folder: str) -> None:
    """What sros2 asks of rclpy and of the ament index, as it is with Fast DDS."""
    _fake("rclpy")
    _fake("rclpy.exceptions", InvalidNamespaceException=ValueError)
    _fake("rclpy.validate_namespace", validate_namespace=lambda name: name.startswith("/"))
    _fake("rclpy.utilities", get_rmw_implementation_identifier=lambda: "rmw_fastrtps_cpp")
    _fake("ament_index_python", get_package_share_directory=lambda _: folder)
    sys.path.insert(0, folder)
    os.environ["XML_CATALOG_FILES"] = f"{folder}/xml_cache/xhtml-cache.xml"


def _make(keystore: Path, policy: Path, enclaves: list[str]) -> None:
    ours = importlib.import_module("sros2.keystore")
    ours.create_keystore(keystore)
    for enclave in enclaves:
        ours.create_enclave(keystore, enclave)
        ours.create_permission(keystore, enclave, policy)


if __name__ == "__main__":
    _without_rclpy(sys.argv[1])
    _make(Path(sys.argv[2]), Path(sys.argv[3]), sys.argv[4:])
