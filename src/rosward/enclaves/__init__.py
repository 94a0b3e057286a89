# SPDX-License-Identifier: Apache-2.0
"""How can a system do with fewer enclaves, or an enclave with fewer rules, and what does that cost in rights that nobody needs?"""
