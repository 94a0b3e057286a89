# SPDX-License-Identifier: Apache-2.0
"""Why is something in the result? Records that the outputs write down."""
