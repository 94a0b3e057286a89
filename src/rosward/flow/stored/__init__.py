# SPDX-License-Identifier: Apache-2.0
"""What stands in the objects of a program, as far as flow is concerned; what a walk reads and writes of it; by which lines it came."""
