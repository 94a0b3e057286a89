# SPDX-License-Identifier: Apache-2.0
"""What is written for people and programs: each output a pure function of the network, one a file.

Import the module that you need; what draws, renders and prints is slow to import, and often not asked for.
"""
