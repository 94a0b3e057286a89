# SPDX-License-Identifier: Apache-2.0
"""What stands behind the pages of docs/: links, runs that are shown, references that are generated. Knows nothing of MkDocs."""
