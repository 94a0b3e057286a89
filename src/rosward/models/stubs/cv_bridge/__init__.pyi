# SPDX-License-Identifier: Apache-2.0
"""cv_bridge: conversions only.

Read from ros-perception/vision_opencv, branch rolling (2024-02).
"""

from _rosward import pure, reads_only

from cv_bridge.core import CvBridge as CvBridge, CvBridgeError as CvBridgeError

pure(__name__)
reads_only(__name__)


def cvtColorForDisplay(
    source, encoding_in, encoding_out, do_dynamic_scaling=False, min_image_value=0.0, max_image_value=0.0, colormap=-1
): ...
def getCvType(encoding) -> int: ...
