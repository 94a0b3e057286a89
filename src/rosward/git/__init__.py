# SPDX-License-Identifier: Apache-2.0
"""The sources as they were at a commit, in a folder of their own, without a program of the repository having run."""
