# SPDX-License-Identifier: Apache-2.0
"""Which libraries without a model are known to change no list, dict or object that they are given, or to create nothing on a node?

cv2.imshow('image', frame)       reads
random.shuffle(self.names)       changes: the exceptions have names of their own
bus.readinto(self.buf)           not known, so it may change
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

from rosward.domain.compound import External, Native
from rosward.domain.unknown import Cause
from rosward.domain.values import Unknown, Value
from rosward.source.standard_library import STANDARD_LIBRARY

_WINDOWS: Final = {
    "PyQt4", "PyQt5", "PyQt6", "PySide2", "PySide6", "python_qt_binding", "tkinter", "Tkinter", "customtkinter", "pygame",
    "pyqtgraph",
}  # fmt: skip
"""What draws windows. `QApplication(sys.argv)` takes out the words that Qt knows, of which none is for ROS."""

_READ: Final = _WINDOWS | {
    "builtins", "numpy", "scipy", "cv2", "PIL", "matplotlib", "mpl_toolkits", "pandas", "sklearn", "skimage", "tensorflow",
    "keras", "torch", "torchvision", "onnxruntime", "mathutils", "transforms3d", "open3d", "sympy", "requests", "urllib",
    "http", "struct", "random", "statistics", "hashlib", "base64", "binascii", "uuid", "secrets", "locale", "textwrap",
    "unicodedata", "zlib", "gzip", "shutil", "tempfile", "pprint", "termcolor", "colorama",
    "simplejson", "ujson", "orjson", "msgpack", "bson",
}  # fmt: skip
"""Libraries whose functions and objects only read what they are given, as they are documented."""

_WRITE: Final = frozenset(
    {
        "shuffle", "copyto", "put", "putmask", "place", "fill_diagonal", "put_along_axis", "unpack_to",
        "save", "savez", "savez_compressed", "savetxt", "savefig", "dump", "to_csv", "to_json", "to_pickle",  # to an open file
    }
)  # fmt: skip
"""The last words of the names of those that change it all the same."""

_FOREIGN: Final = _READ | {
    "can", "serial", "smbus", "smbus2", "RPi", "selectors", "selectors2", "asyncio", "threading", "socket",
}  # fmt: skip
"""Libraries that create nothing on a node that they get hold of: they know nothing of ROS."""

_NO_NODES: Final = _FOREIGN | {
    "actionlib", "aiohttp", "aiortc", "anthropic",
    "av", "azure", "bleak", "bluetooth", "board", "boto3", "bs4", "busio", "canopen", "cantools", "casadi",
    "crcmod", "Crypto", "cryptography", "cvxpy", "dash", "depthai", "digitalio", "discord", "docker", "dotenv", "dronekit", "dynamixel_sdk",
    "easyocr", "evdev", "face_recognition", "fastapi", "filterpy", "flask", "flask_cors", "flask_socketio", "folium", "geographiclib",
    "geopy", "google", "gpiozero", "gradio", "grpc", "gtts", "gym", "gymnasium", "h5py", "httpx", "image_geometry", "imageio", "imutils",
    "influxdb_client", "inputs", "jinja2", "joblib", "kivy", "langchain", "langchain_core", "langchain_openai", "langgraph", "laser_geometry",
    "librosa", "loguru", "lxml", "mavsdk", "mcap", "mediapipe", "minimalmodbus", "mss", "mujoco", "mysql", "neopixel", "netifaces", "networkx",
    "nicegui", "numba", "odrive", "ollama", "openai", "osqp", "paho", "paramiko", "pexpect", "picamera", "picamera2", "pigpio", "pinocchio",
    "playsound", "plotly", "PyKDL", "prompt_toolkit", "psutil", "psycopg2", "pupil_apriltags", "pyaudio", "pyautogui", "pybullet", "pycuda",
    "pydantic", "pydub", "pymavlink", "pymodbus", "pymongo", "pynmea2", "pynput", "pyproj", "pyrealsense2", "pyttsx3", "pytz",
    "pyudev", "pyzbar", "rclpy_message_converter", "readchar", "redis", "rich", "rosbag", "rosbags", "rospy",
    "ruamel", "shapely", "simple_pid", "slack_sdk", "smach", "socketio",
    "sounddevice", "soundfile", "spatialmath", "speech_recognition", "sqlalchemy", "sshkeyboard", "stable_baselines3", "starlette",
    "streamlit", "supervision", "telegram", "tensorrt", "textual", "torchaudio", "tornado", "tqdm", "transformers", "trimesh", "twilio",
    "typer", "ultralytics", "usb", "utm", "uvicorn", "vosk", "webrtcvad", "websocket", "websockets", "werkzeug", "whisper", "wx", "xarm",
    "yaml", "zeroconf", "zmq",
}  # fmt: skip
"""Libraries of which no class is a node. Some call what they are given, so of a node that they get more may be unknown."""

_OF_ROS: Final = re.compile(r"rosbag2_py\.(?!.*(?:Recorder|Player)$)|moveit\.core\.")
"""Classes that are no nodes of libraries that have some."""

_ASK: Final = tuple(f"{package}.api." for package in ("ros2node", "ros2topic", "ros2service", "ros2action"))
"""Modules whose functions only ask the graph. Others of these packages create something: `ros2topic.verb.pub.publisher(node, …)`."""

_IN_CPP: Final = re.compile(
    r"(?:Q(?!\w*(?:Node|Ros|ROS))[A-Z]\w*|Ui)(?:\.|$)"
    r"|BT\.\w+\.(?:name|getInput|setOutput|config|status|isHalted|UID|fullPath|registrationName|emitWakeUpSignal)$"
)
"""Classes of Qt, what its tools make of the description of a window, and what a node of a behaviour tree is asked: its base knows nothing of ROS.
`QNode` is what many packages call a node of theirs that has a window."""


def creates_nothing(callee: Value) -> bool:
    """Whether it is known of what is called that it creates nothing on a node."""
    return all(
        name.partition(".")[0] in _FOREIGN or name.startswith(_ASK) or _IN_CPP.match(name) for name in _dotted(callee)
    )


def makes_no_node(callee: External) -> bool:
    """Whether it is known of a class that it is no node, and makes none."""
    return (
        callee.name.partition(".")[0] in _NO_NODES or _OF_ROS.match(callee.name) is not None or creates_nothing(callee)
    )


def knows_no_types(callee: Value) -> bool:
    """Whether it is known of what is called that it creates nothing with an interface type: Python itself, or a library without nodes."""
    return all(name.partition(".")[0] in STANDARD_LIBRARY or makes_no_node(External(name)) for name in _dotted(callee))


def decisive(bases: Iterable[Value]) -> Value | None:
    """Of the bases of a class that are not known, the one that says what may be created: Qt hands on to the next base what it does not take."""
    outside = [base for base in bases if isinstance(base, (External, Unknown))]
    return next((base for base in outside if not creates_nothing(base)), outside[0] if outside else None)


def only_reads(callee: Value) -> bool:
    """Whether it is known of what is called that it changes nothing: what a message holds is plain data, so nothing of it does."""
    if isinstance(callee, Unknown) and callee.reasons and all(r.cause is Cause.MESSAGE for r in callee.reasons):
        return True
    return all(_reads(name) for name in _dotted(callee))


def _reads(name: str) -> bool:
    last = name.rpartition(".")[2]
    return name.partition(".")[0] in _READ and last not in _WRITE and not last.endswith("_into")


def _dotted(callee: Value) -> list[str]:
    """The names under which it may be known, all of which have to be asked: of what a star import gives, one for each module that may have it."""
    if isinstance(callee, (External, Native)):
        return [callee.name]
    if isinstance(callee, Unknown) and len(callee.reasons) == 1:
        cause, subject, _ = callee.reasons[0]
        if cause is Cause.CALL:
            return [subject]
        if cause is Cause.MODULE:
            modules, _, name = subject.rpartition(": ")
            if modules:
                return [f"{module}.{name}" for module in modules.split(" or ")]
            return [name] if "." in name else [""]  # the name of an attribute alone says nothing of a library
    return [""]
