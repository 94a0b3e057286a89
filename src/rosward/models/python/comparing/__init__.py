# SPDX-License-Identifier: Apache-2.0
"""When are two values equal, and which comes first?"""
