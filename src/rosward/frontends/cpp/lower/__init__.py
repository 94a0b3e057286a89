# SPDX-License-Identifier: Apache-2.0
"""How does C++ become operations? One module for each kind of syntax; `entry` is the door."""
