# SPDX-License-Identifier: Apache-2.0
"""What a value of a type is: where it stands, what it converts to, what a copy of it holds."""
