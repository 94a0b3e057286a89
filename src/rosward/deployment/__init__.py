# SPDX-License-Identifier: Apache-2.0
"""What is started, and how: launch files, parameter files, command lines and declared nodes."""
