# SPDX-License-Identifier: Apache-2.0
"""What do the models of launch ask for?"""
