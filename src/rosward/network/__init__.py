# SPDX-License-Identifier: Apache-2.0
"""The computation graph of a whole system: what the analysis found, connected, frozen and sorted."""
