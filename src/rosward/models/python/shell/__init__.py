# SPDX-License-Identifier: Apache-2.0
"""What do the lines of a shell start?"""
