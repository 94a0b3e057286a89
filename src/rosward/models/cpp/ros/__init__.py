# SPDX-License-Identifier: Apache-2.0
"""What the headers of the models ask for where C++ cannot say it: the namespace `rosward`."""
