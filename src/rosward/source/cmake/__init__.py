# SPDX-License-Identifier: Apache-2.0
"""What a CMakeLists.txt says: which files it installs (`installed`), and which programs it builds (`build`)."""
