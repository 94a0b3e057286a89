# SPDX-License-Identifier: Apache-2.0
"""What libraries do: stub files that declare their effects, and code where a declaration cannot say it."""
