# SPDX-License-Identifier: Apache-2.0
"""What was found out before, and still holds? Results are kept with all that they depend on."""
