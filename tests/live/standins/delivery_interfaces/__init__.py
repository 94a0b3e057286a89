# SPDX-License-Identifier: Apache-2.0
"""Stands in for the example's own interfaces, which only a build with CMake would make."""
