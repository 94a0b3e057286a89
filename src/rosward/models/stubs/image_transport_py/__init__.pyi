# SPDX-License-Identifier: Apache-2.0
"""image_transport_py: makes a node of its own (a C++ one) and one topic for each transport plugin that is installed.

Read from ros-perception/image_common 6.0.1 (rolling, 2024-10): image_transport_py/src and image_transport/src.
"""

from _rosward import beside, create, create_node, message, reads_only, schedule, unknown
from sensor_msgs.msg import CameraInfo, CompressedImage, Image

reads_only(__name__)


class Publisher:
    def get_topic(self) -> str: ...
    def get_num_subscribers(self) -> int: ...
    def shutdown(self) -> None: ...
    def publish(self, img) -> None: ...


class CameraPublisher:
    def get_topic(self) -> str: ...
    def get_num_subscribers(self) -> int: ...
    def shutdown(self) -> None: ...
    def publish(self, img, info) -> None: ...


class Subscriber:
    def get_topic(self) -> str: ...
    def get_num_publishers(self) -> int: ...
    def get_transport(self) -> str: ...
    def shutdown(self) -> None: ...


class CameraSubscriber:
    def get_topic(self) -> str: ...
    def get_num_publishers(self) -> int: ...
    def get_transport(self) -> str: ...
    def shutdown(self) -> None: ...


class ImageTransport:
    def __init__(self, node_name, image_transport="", launch_params_filepath=""):
        beside()  # a thread of its own spins that node
        create_node(
            self,
            node_name,
            namespace="",
            use_global_arguments=False,
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        if launch_params_filepath:
            self._transport = unknown("file", "parameter file of ImageTransport")
        else:
            self._transport = image_transport or "raw"

    def advertise(self, base_topic, queue_size, latch=False) -> Publisher:
        create("publisher", self, base_topic, Image, qos=queue_size)
        if unknown("environment", "plugins of image_transport"):
            create("publisher", self, base_topic + "/compressed", CompressedImage, qos=queue_size)
            create("publisher", self, base_topic + "/compressedDepth", CompressedImage, qos=queue_size)
            create("publisher", self, base_topic + "/zstd", CompressedImage, qos=queue_size)
            create("publisher", self, base_topic + "/theora", unknown("environment", "theora_image_transport/msg/Packet"))
        return Publisher()

    def advertise_camera(self, base_topic, queue_size, latch=False) -> CameraPublisher:
        self.advertise(base_topic, queue_size, latch)
        create("publisher", self, _camera_info(base_topic), CameraInfo, qos=queue_size)
        return CameraPublisher()

    def subscribe(self, base_topic, queue_size, callback):
        self._subscribe(base_topic, queue_size, callback)
        schedule(callback, message(Image, "image"), event="message")
        return Subscriber()

    def subscribe_camera(self, base_topic, queue_size, callback):
        self._subscribe(base_topic, queue_size, callback)
        create("subscription", self, _camera_info(base_topic), CameraInfo, qos=queue_size, callback=callback)
        schedule(callback, message(Image, "image"), message(CameraInfo, "camera info"), event="message")
        return CameraSubscriber()

    def _subscribe(self, base_topic, queue_size, callback):
        if self._transport == "raw":
            create("subscription", self, base_topic, Image, qos=queue_size, callback=callback)
        else:
            create(
                "subscription",
                self,
                base_topic + "/" + self._transport,
                CompressedImage,
                qos=queue_size,
                callback=callback,
            )


def _camera_info(base_topic):
    """image_transport/src/camera_common.cpp: the last part of the topic becomes camera_info."""
    return base_topic.rpartition("/")[0] + "/camera_info" if "/" in base_topic else "camera_info"
