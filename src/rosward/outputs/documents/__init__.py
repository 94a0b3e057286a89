# SPDX-License-Identifier: Apache-2.0
"""What programs read: JSON, SARIF, JUnit, annotations."""
