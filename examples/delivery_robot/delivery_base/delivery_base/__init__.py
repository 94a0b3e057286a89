# SPDX-License-Identifier: Apache-2.0
"""Drive, battery and manual control of the delivery robot."""
