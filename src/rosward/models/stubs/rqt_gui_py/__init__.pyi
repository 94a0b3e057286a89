# SPDX-License-Identifier: Apache-2.0
"""rqt_gui_py: plugins in Python, see plugin.pyi."""
