# SPDX-License-Identifier: Apache-2.0
"""The functions of libraries by which something leaves ROS or comes into it, and those that only compute.

Names are dotted; a `*` stands for any word, `**` for any words. A method of what a function gives is named behind that: `cv2.VideoCapture.read`.
"""

from __future__ import annotations

from typing import Final

from rosward.records import NamedTuple


class Effect(NamedTuple):
    """What the functions of these names do: where what they get goes, where what they give comes from."""

    names: str
    sink: str = ""
    source: str = ""


_LOGGER: Final = "rclpy.impl.rcutils_logger.RcutilsLogger"
_PYTHON: Final = ("logging.Logger", "logging.getLogger", "logging")
_LEVELS: Final = ("debug", "info", "warn", "warning", "error", "fatal", "critical", "exception", "log")

FUNCTIONS: Final = (
    Effect(" ".join(f"{_LOGGER}.{level}" for level in _LEVELS), sink="log"),
    *(
        Effect(" ".join(f"{logger}.{level}" for logger in _PYTHON for level in _LEVELS), sink=sink)
        for sink in ("stdout", "file")  # its handlers decide
    ),
    Effect("print builtins.print sys.stdout.write sys.stderr.write pprint.pprint", sink="stdout"),
    Effect(
        "open.write open.writelines io.open.write codecs.open.write json.dump yaml.dump_all pickle.dump numpy.save "
        "numpy.savetxt numpy.savez cv2.imwrite cv2.VideoWriter.write os.write shutil.copy csv.writer.writerow "
        "csv.writer.writerows csv.DictWriter.writerow csv._writer.writerow csv._writer.writerows "
        "pathlib.Path.write_text pathlib.Path.write_bytes "
        "os.remove os.rename os.mkdir os.makedirs",
        sink="file",
    ),
    Effect(
        "open.read open.readline open.readlines io.open.read numpy.load numpy.loadtxt numpy.genfromtxt cv2.imread "
        "pathlib.Path.read_text pathlib.Path.read_bytes os.listdir os.path.exists os.path.isfile glob.glob "
        "pickle.load json.load yaml.load yaml.safe_load pandas.read_csv",
        source="file",
    ),
    Effect(
        "socket.socket.send socket.socket.sendall socket.socket.sendto socket.socket.sendmsg "
        "socket.create_connection.send socket.create_connection.sendall requests.* requests.Session.* "
        "urllib.request.urlopen urllib.request.Request http.client.HTTPConnection.request "
        "paho.mqtt.client.Client.publish boto3.** openai.** aiohttp.** httpx.** grpc.** firebase_admin.** pymongo.** "
        "psycopg2.** influxdb** telegram.** twilio.** google.cloud.** websocket.create_connection.send websocket.WebSocketApp.send "
        "websockets.connect.send zmq.Context.socket.send* zmq.Context.socket.send smtplib.SMTP.*",
        sink="network",
    ),
    Effect(
        "socket.socket.recv socket.socket.recvfrom socket.socket.recv_into socket.create_connection.recv "
        "boto3.** openai.** aiohttp.** httpx.** grpc.** firebase_admin.** pymongo.** psycopg2.** influxdb** google.cloud.** "
        "socket.socket.accept requests.* requests.Session.* urllib.request.urlopen urllib.request.urlopen.read "
        "http.client.HTTPConnection.getresponse websocket.create_connection.recv zmq.Context.socket.recv* "
        "zmq.Context.socket.recv",
        source="network",
    ),
    Effect(
        "subprocess.run subprocess.call subprocess.check_call subprocess.check_output subprocess.Popen "
        "subprocess.getoutput subprocess.Popen.communicate subprocess.Popen.stdin.write os.system os.popen "
        "os.execv os.execvp os.spawnl os.kill pexpect.spawn pexpect.spawn.sendline",
        sink="process",
    ),
    Effect(
        "subprocess.run subprocess.check_output subprocess.getoutput subprocess.Popen.communicate "
        "subprocess.Popen.stdout.read subprocess.Popen.stdout.readline subprocess.Popen.poll subprocess.Popen.wait "
        "subprocess.call os.popen os.popen.read os.system",
        source="process",
    ),
    Effect(
        "serial.Serial.write smbus.SMBus.write* smbus2.SMBus.write* RPi.GPIO.output gpiozero.* "
        "RPi.GPIO.PWM.ChangeDutyCycle pyttsx3.init.say playsound.playsound",
        sink="device",
    ),
    Effect(
        "serial.Serial.read serial.Serial.readline serial.Serial.read_until serial.Serial.read_all smbus.SMBus.read* "
        "smbus2.SMBus.read* RPi.GPIO.input cv2.VideoCapture.read cv2.VideoCapture.get cv2.VideoCapture.isOpened "
        "cv2.VideoCapture psutil.*",
        source="device",
    ),
    Effect(
        "can.Bus.send can.Bus.send_periodic can.ThreadSafeBus.send can.interface.Bus.send pymodbus.client.*.write* "
        "odrive.* pigpio.pi.write pigpio.pi.set_servo_pulsewidth board.* busio.I2C.writeto spidev.SpiDev.xfer*",
        sink="device",
    ),
    Effect(
        "can.Bus.recv can.Bus can.ThreadSafeBus.recv can.ThreadSafeBus can.interface.Bus.recv can.interface.Bus "
        "pymodbus.client.*.read* pigpio.pi.read picamera.* picamera2.* pyrealsense2.* smbus2.* busio.I2C.readfrom_into "
        "spidev.SpiDev.xfer*",
        source="device",
    ),
    Effect(
        "eval exec builtins.eval builtins.exec compile builtins.compile __import__ importlib.import_module", sink="code"
    ),
    Effect(
        "pickle.loads pickle.load pickle.Unpickler.load dill.loads cloudpickle.loads marshal.loads jsonpickle.decode "
        "yaml.unsafe_load shelve.open",
        sink="pickle",
    ),
    Effect("input builtins.input sys.stdin.read sys.stdin.readline", source="stdin"),
    Effect(
        "time.time time.monotonic time.perf_counter time.time_ns time.monotonic_ns time.localtime time.strftime "
        "time.ctime datetime.datetime.now datetime.datetime.utcnow datetime.datetime.today datetime.date.today "
        "rclpy.clock.Clock.now rclpy.clock.ROSClock.now",
        source="clock",
    ),
    Effect(
        "random.* numpy.random.* numpy.random.default_rng.* secrets.* uuid.uuid1 uuid.uuid4 os.urandom",
        source="random",
    ),
    Effect("os.getenv os.environ.get", source="env"),
    Effect(
        "tf2_ros.buffer.Buffer.lookup_transform tf2_ros.buffer.Buffer.transform tf2_ros.buffer.Buffer.can_transform "
        "tf2_ros.buffer.Buffer.lookup_transform_async tf2_ros.buffer_interface.BufferInterface.transform "
        "tf2_ros.Buffer.lookup_transform tf2_ros.Buffer.transform",
        source="tf",
    ),
    Effect(
        "tf2_ros.transform_broadcaster.TransformBroadcaster.sendTransform "
        "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster.sendTransform",
        sink="tf",
    ),
)

PURE: Final = (
    "math.* numpy.* scipy.* cv2.cvtColor cv2.inRange cv2.resize "
    "cv2.findContours cv2.contourArea cv2.boundingRect "
    "cv2.imshow cv2.waitKey cv2.namedWindow cv2.destroyAllWindows cv2.moments "
    "cv2.GaussianBlur cv2.blur cv2.medianBlur cv2.Canny cv2.threshold cv2.bitwise_* cv2.imread "
    "cv2.warpPerspective cv2.HoughLines* cv2.HoughCircles cv2.erode cv2.dilate cv2.minEnclosingCircle cv2.addWeighted "
    "cv2.getPerspectiveTransform cv2.flip cv2.rotate cv2.split cv2.merge cv2.connectedComponents* cv2.imencode "
    "cv2.imdecode cv2.Rodrigues cv2.approxPolyDP cv2.arcLength cv2.convexHull cv2.minAreaRect cv2.boxPoints "
    "json.* base64.* struct.* hashlib.* datetime.* time.* transforms3d.* tf_transformations.* tf2_geometry_msgs.* "
    "copy.* collections.* itertools.* functools.* operator.* string.* textwrap.* decimal.* fractions.* statistics.* "
    "shapely.* pyproj.* utm.* geometry.* quaternion.* random.* os.getenv os.path.* socket.* requests.* subprocess.*"
)
"""They read what they get, write nothing to it, and what they give is no part of it: `*` stands for any dotted rest."""

WRITES: Final = frozenset(
    [
        "numpy.copyto",
        "numpy.put",
        "numpy.place",
        "numpy.putmask",
        "numpy.fill_diagonal",
        "numpy.nan_to_num",
        "numpy.random.shuffle",
        "random.shuffle",
        "struct.pack_into",
        "numpy.add.at",
        "numpy.put_along_axis",
        "socket.socket.recv_into",
    ]
)
"""Those of them that write to what they get all the same."""

STOPS: Final = frozenset(
    {
        "rclpy.timer.Timer.cancel",
        "rclpy.timer.Timer.reset",
        "rclpy.timer.Timer.destroy",
        "rclpy.subscription.Subscription.destroy",
        "rclpy.node.Node.destroy_subscription",
        "rclpy.node.Node.destroy_timer",
        "rclpy.node.Node.destroy_service",
    }
)
"""What they are called on, or given, runs no more, or again."""

MUTATORS: Final = frozenset(
    (
        *("__init__", "__setitem__", "__iadd__", "__isub__", "__imul__", "__itruediv__", "__ifloordiv__", "__imod__"),
        *("__ipow__", "__iand__", "__ior__", "__ixor__", "__imatmul__", "fill", "sort", "put", "partition", "resize"),
        *("itemset", "setfield", "byteswap", "append", "extend"),
    )
)
"""Methods that write to their object."""
