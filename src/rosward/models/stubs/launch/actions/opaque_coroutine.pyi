# SPDX-License-Identifier: Apache-2.0
"""launch.actions.opaque_coroutine."""

from launch.actions import OpaqueCoroutine as OpaqueCoroutine
