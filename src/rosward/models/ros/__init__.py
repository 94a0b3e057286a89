# SPDX-License-Identifier: Apache-2.0
"""What does the client library do? Effects, interfaces, parameters."""
