# SPDX-License-Identifier: Apache-2.0
"""rqt_gui: windows of plugins, see main.pyi."""
