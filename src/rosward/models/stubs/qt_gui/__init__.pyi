# SPDX-License-Identifier: Apache-2.0
"""qt_gui: what rqt_gui is made of, see plugin.pyi. Its other modules have no model."""
