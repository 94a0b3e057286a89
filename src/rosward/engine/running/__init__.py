# SPDX-License-Identifier: Apache-2.0
"""What the engine holds of a process while it runs: calls in progress, what was seen and scheduled, how precisely it is followed."""
