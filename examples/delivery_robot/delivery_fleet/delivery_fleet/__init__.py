# SPDX-License-Identifier: Apache-2.0
"""The building side: orders, doors and monitoring of the delivery robots."""
