# SPDX-License-Identifier: Apache-2.0
"""SROS2 policies and DDS permissions as they are: read, matched as DDS matches, compared with what the code needs."""
