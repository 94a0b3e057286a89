# SPDX-License-Identifier: Apache-2.0
"""Localisation and delivery runs of the delivery robot."""
