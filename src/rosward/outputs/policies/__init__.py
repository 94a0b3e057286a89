# SPDX-License-Identifier: Apache-2.0
"""What DDS Security reads: policies, permissions, enclaves."""
