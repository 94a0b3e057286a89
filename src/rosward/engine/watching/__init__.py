# SPDX-License-Identifier: Apache-2.0
"""What is noted of a program while it runs, for those who ask for flows."""
