# SPDX-License-Identifier: Apache-2.0
"""Information flow: what each output of a process is made of, and what decides it."""
