# SPDX-License-Identifier: Apache-2.0
"""can.interface."""

from can import Bus as Bus
