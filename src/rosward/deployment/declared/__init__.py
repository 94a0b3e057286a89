# SPDX-License-Identifier: Apache-2.0
"""The declared interfaces of programs whose source is elsewhere: read, and executed for one start."""
