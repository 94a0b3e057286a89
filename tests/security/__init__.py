# SPDX-License-Identifier: Apache-2.0
"""Our policies, held against an implementation of DDS Security that others wrote, and against the readers of policies."""
