# SPDX-License-Identifier: Apache-2.0
"""What does an enclave need to start with security? Everything around our permissions: authorities, keys, certificates,
a governance document and signatures, by the `openssl` command alone.

    Keystore(folder, domain=7).enclave("/talker", permissions_xml(network, "/talker", 7))
      ->  a folder with the six files of DDS Security

The permissions have an authority of their own, apart from that of the identities.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import Final

__all__ = ["GOVERNANCE", "Keystore", "has_openssl"]

GOVERNANCE: Final = """\
<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
     xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      <domains><id>{domain}</id></domains>
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>SIGN</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>ENCRYPT</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
"""
"""As strict as the one that sros2 writes: who is not authenticated does not join, and each topic is controlled."""

_NEW_KEY: Final = ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-sha256", "-days", "30")


def has_openssl() -> bool:
    """Whether the command is there."""
    return shutil.which("openssl") is not None


def _openssl(*arguments: str | Path) -> None:
    subprocess.run(["openssl", *map(str, arguments)], check=True, capture_output=True, timeout=300)


class Keystore:
    """Two authorities and the enclaves that they vouch for, in one domain."""

    def __init__(self, folder: Path, domain: int) -> None:
        self.domain = domain
        self._folder = folder
        self._issued = 0
        folder.mkdir(parents=True)
        for authority in ("identity_ca", "permissions_ca"):
            key, certificate = self._of(authority)
            _openssl("req", "-x509", *_NEW_KEY, "-keyout", key, "-out", certificate, "-subj", f"/CN={authority}")
        self._governance = folder / "governance.p7s"
        self._sign(GOVERNANCE.format(domain=domain), self._governance)

    def enclave(self, path: str, permissions: str) -> Path:
        """The folder of a new enclave of this path with these permissions, which come unsigned as our outputs are."""
        self._issued += 1
        folder = self._folder / "enclaves" / str(self._issued)
        folder.mkdir(parents=True)
        key, certificate = self._of("identity_ca")
        subject = "/CN=" + path.replace("/", "\\/")
        own = ("-keyout", folder / "key.pem", "-out", folder / "cert.pem")
        _openssl("req", "-x509", "-CA", certificate, "-CAkey", key, *_NEW_KEY, *own, "-subj", subject)
        for authority in ("identity_ca", "permissions_ca"):
            shutil.copy(self._of(authority)[1], folder / f"{authority}.cert.pem")
        shutil.copy(self._governance, folder)
        self._sign(permissions, folder / "permissions.p7s")
        return folder

    def _of(self, authority: str) -> tuple[Path, Path]:
        return self._folder / f"{authority}.key.pem", self._folder / f"{authority}.cert.pem"

    def _sign(self, document: str, signed: Path) -> None:
        key, certificate = self._of("permissions_ca")
        plain = signed.with_suffix(".xml")
        plain.write_text(document, encoding="utf-8")
        _openssl("smime", "-sign", "-text", "-in", plain, "-out", signed, "-signer", certificate, "-inkey", key)
