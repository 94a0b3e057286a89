# SPDX-License-Identifier: Apache-2.0
"""cv_bridge.core: conversions, of which a bridge keeps nothing.

Read from ros-perception/vision_opencv, branch rolling (2024-02).
"""

from _rosward import pure, reads_only

from sensor_msgs.msg import CompressedImage, Image

pure(__name__)
reads_only(__name__)


def _image(img_msg): ...
def _unpacked(cmprs_img_msg): ...


class CvBridgeError(TypeError): ...


class CvBridge:
    def __init__(self) -> None: ...
    def dtype_with_channels_to_cvtype2(self, dtype, n_channels) -> str: ...
    def cvtype2_to_dtype_with_channels(self, cvtype): ...
    def encoding_to_cvtype2(self, encoding): ...
    def encoding_to_dtype_with_channels(self, encoding): ...

    def compressed_imgmsg_to_cv2(self, cmprs_img_msg, desired_encoding="passthrough"):
        return _unpacked(cmprs_img_msg)

    def imgmsg_to_cv2(self, img_msg, desired_encoding="passthrough"):
        return _image(img_msg)  # without a conversion, over the bytes of the message

    def cv2_to_compressed_imgmsg(self, cvim, dst_format="jpg") -> CompressedImage: ...
    def cv2_to_imgmsg(self, cvim, encoding="passthrough", header=None) -> Image: ...
