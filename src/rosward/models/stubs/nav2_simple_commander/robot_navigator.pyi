# SPDX-License-Identifier: Apache-2.0
"""nav2_simple_commander.robot_navigator: a node with the clients of Nav2, more of them in each distribution.

Read from ros-navigation/navigation2, branches humble (2026-06), iron (2024-10), jazzy (2026-08), kilted (2026-01), lyrical and main (2026-08).
"""

from enum import Enum

import rclpy
from _rosward import changes, creator, either, native, pure, reads_only, unknown
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from lifecycle_msgs.srv import GetState
from nav2_msgs.action import (
    AssistedTeleop,
    BackUp,
    ComputeAndTrackRoute,
    ComputePathThroughPoses,
    ComputePathToPose,
    ComputeRoute,
    DockRobot,
    DriveOnHeading,
    FollowGPSWaypoints,
    FollowObject,
    FollowPath,
    FollowWaypoints,
    NavigateThroughPoses,
    NavigateToPose,
    SmoothPath,
    Spin,
    UndockRobot,
)
from nav2_msgs.srv import (
    ClearCostmapAroundPose,
    ClearCostmapAroundRobot,
    ClearCostmapExceptRegion,
    ClearEntireCostmap,
    GetCostmap,
    LoadMap,
    ManageLifecycleNodes,
    Toggle,
)
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSHistoryPolicy, QoSProfile, QoSReliabilityPolicy


@native
def _since(distro) -> bool:
    """Whether the analysis is for `distro` or a later one."""


class TaskResult(Enum):
    UNKNOWN = 0
    SUCCEEDED = 1
    CANCELED = 2
    FAILED = 3


class RunningTask(Enum):
    NONE = 0
    NAVIGATE_TO_POSE = 1
    NAVIGATE_THROUGH_POSES = 2
    FOLLOW_PATH = 3
    FOLLOW_WAYPOINTS = 4
    FOLLOW_GPS_WAYPOINTS = 5
    SPIN = 6
    BACKUP = 7
    DRIVE_ON_HEADING = 8
    ASSISTED_TELEOP = 9
    DOCK_ROBOT = 10
    UNDOCK_ROBOT = 11
    COMPUTE_AND_TRACK_ROUTE = 12
    FOLLOW_OBJECT = 13


@changes("made")
def _fill(made, content) -> None: ...
@pure
def _tells(answer) -> bool: ...
@pure
def _code(answer) -> int: ...
@pure
def _words(answer) -> str: ...


def _made(made, content):
    _fill(made, content)
    return made


@creator
class BasicNavigator(Node):
    def __init__(self, node_name="basic_navigator", namespace=""):
        super().__init__(node_name=node_name, namespace=namespace)
        self.initial_pose = PoseStamped()
        self.goal_handle = None
        self.result_future = None
        self.feedback = None
        self.status = None
        self.initial_pose_received = False
        amcl_pose_qos = QoSProfile(
            durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
            reliability=QoSReliabilityPolicy.RELIABLE,
            history=QoSHistoryPolicy.KEEP_LAST,
            depth=1,
        )
        self.nav_through_poses_client = ActionClient(self, NavigateThroughPoses, "navigate_through_poses")
        self.nav_to_pose_client = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self.follow_waypoints_client = ActionClient(self, FollowWaypoints, "follow_waypoints")
        self.follow_path_client = ActionClient(self, FollowPath, "follow_path")
        self.compute_path_to_pose_client = ActionClient(self, ComputePathToPose, "compute_path_to_pose")
        self.compute_path_through_poses_client = ActionClient(
            self, ComputePathThroughPoses, "compute_path_through_poses"
        )
        self.smoother_client = ActionClient(self, SmoothPath, "smooth_path")
        self.spin_client = ActionClient(self, Spin, "spin")
        self.backup_client = ActionClient(self, BackUp, "backup")
        self.assisted_teleop_client = ActionClient(self, AssistedTeleop, "assisted_teleop")
        self.localization_pose_sub = self.create_subscription(
            PoseWithCovarianceStamped, "amcl_pose", self._amclPoseCallback, amcl_pose_qos
        )
        self.initial_pose_pub = self.create_publisher(PoseWithCovarianceStamped, "initialpose", 10)
        self.change_maps_srv = self.create_client(LoadMap, "map_server/load_map")
        self.clear_costmap_global_srv = self.create_client(
            ClearEntireCostmap, "global_costmap/clear_entirely_global_costmap"
        )
        self.clear_costmap_local_srv = self.create_client(
            ClearEntireCostmap, "local_costmap/clear_entirely_local_costmap"
        )
        self.get_costmap_global_srv = self.create_client(GetCostmap, "global_costmap/get_costmap")
        self.get_costmap_local_srv = self.create_client(GetCostmap, "local_costmap/get_costmap")
        if _since("iron"):
            self.follow_gps_waypoints_client = ActionClient(self, FollowGPSWaypoints, "follow_gps_waypoints")
        if _since("jazzy"):
            self.drive_on_heading_client = ActionClient(self, DriveOnHeading, "drive_on_heading")
            self.docking_client = ActionClient(self, DockRobot, "dock_robot")
            self.undocking_client = ActionClient(self, UndockRobot, "undock_robot")
            self.clear_costmap_except_region_srv = self.create_client(
                ClearCostmapExceptRegion, "local_costmap/clear_costmap_except_region"
            )
            self.clear_costmap_around_robot_srv = self.create_client(
                ClearCostmapAroundRobot, "local_costmap/clear_costmap_around_robot"
            )
        if _since("lyrical") or not _since("kilted") and _since("jazzy"):  # jazzy got it late, kilted never
            self.clear_local_costmap_around_pose_srv = self.create_client(
                ClearCostmapAroundPose, "local_costmap/clear_costmap_around_pose"
            )
        if _since("kilted"):
            self.compute_route_client = ActionClient(self, ComputeRoute, "compute_route")
            self.compute_and_track_route_client = ActionClient(self, ComputeAndTrackRoute, "compute_and_track_route")
        if _since("lyrical"):
            self.following_client = ActionClient(self, FollowObject, "follow_object")
            self.clear_global_costmap_around_pose_srv = self.create_client(
                ClearCostmapAroundPose, "global_costmap/clear_costmap_around_pose"
            )
            self.toggle_collision_monitor_srv = self.create_client(Toggle, "collision_monitor/toggle")

    def _amclPoseCallback(self, msg):
        self.initial_pose_received = True

    def _feedbackCallback(self, msg):
        self.feedback = msg.feedback

    def _send(self, client, *content):
        future = client.send_goal_async(_made(client._action_type.Goal(), content), self._feedbackCallback)
        rclpy.spin_once(self)
        self.goal_handle = future.result()
        self.result_future = self.goal_handle.get_result_async()
        return _tells(self.goal_handle)

    def _compute(self, client, *content):
        future = client.send_goal_async(_made(client._action_type.Goal(), content))
        rclpy.spin_once(self)
        return either(future.result().get_result_async().result().result, unknown("live", "answer of Nav2"))

    def _ask(self, client, *content):
        future = client.call_async(_made(client.srv_type.Request(), content))
        rclpy.spin_once(self)
        return either(future.result(), unknown("live", "answer of Nav2"))

    def _publish_initial_pose(self):
        self.initial_pose_pub.publish(_made(PoseWithCovarianceStamped(), self.initial_pose))

    def _waitForNodeToActivate(self, node_name):
        self._ask(self.create_client(GetState, f"{node_name}/get_state"))

    def _waitForInitialPose(self):
        self._publish_initial_pose()
        rclpy.spin_once(self)

    def waitUntilNav2Active(self, navigator="bt_navigator", localizer="amcl"):
        if localizer != "robot_localization" or not _since("iron"):
            self._waitForNodeToActivate(localizer)
        if localizer == "amcl":
            self._waitForInitialPose()
        self._waitForNodeToActivate(navigator)

    def lifecycleStartup(self):
        # Asks the running system for services of this type: those of the lifecycle managers, which are called so.
        manager = unknown("live", "names of the lifecycle managers", "str")
        self._ask(self.create_client(ManageLifecycleNodes, f"/{manager}/manage_nodes"))

    def lifecycleShutdown(self):
        self.lifecycleStartup()

    def isTaskComplete(self, task=RunningTask.NONE):
        rclpy.spin_once(self)
        return _tells(self.result_future)

    def getResult(self, task=RunningTask.NONE):
        code = _code(self.result_future)
        if code == 4:
            return TaskResult.SUCCEEDED
        if code == 5:
            return TaskResult.CANCELED
        if code == 6:
            return TaskResult.FAILED
        return TaskResult.UNKNOWN

    # What follows asks Nav2 over the clients above: no further entity. Messages may arrive meanwhile.

    @reads_only
    def destroyNode(self) -> None: ...

    @reads_only
    def destroy_node(self) -> None: ...

    def setInitialPose(self, initial_pose):
        self.initial_pose = initial_pose
        self._publish_initial_pose()

    def goThroughPoses(self, poses, behavior_tree=""):
        return self._send(self.nav_through_poses_client, poses, behavior_tree)

    def goToPose(self, pose, behavior_tree=""):
        return self._send(self.nav_to_pose_client, pose, behavior_tree)

    def followWaypoints(self, poses, number_of_loops=0, goal_index=0):
        return self._send(self.follow_waypoints_client, poses, number_of_loops, goal_index)

    def followGpsWaypoints(self, gps_poses):
        return self._send(self.follow_gps_waypoints_client, gps_poses)

    def spin(self, spin_dist=1.57, time_allowance=10, disable_collision_checks=False):
        return self._send(self.spin_client, spin_dist, time_allowance, disable_collision_checks)

    def backup(self, backup_dist=0.15, backup_speed=0.025, time_allowance=10, disable_collision_checks=False):
        return self._send(self.backup_client, backup_dist, backup_speed, time_allowance, disable_collision_checks)

    def driveOnHeading(self, dist=0.15, speed=0.025, time_allowance=10, disable_collision_checks=False):
        return self._send(self.drive_on_heading_client, dist, speed, time_allowance, disable_collision_checks)

    def assistedTeleop(self, time_allowance=30):
        return self._send(self.assisted_teleop_client, time_allowance)

    def followPath(self, path, controller_id="", goal_checker_id="", progress_checker_id="", path_handler_id=""):
        return self._send(
            self.follow_path_client, path, controller_id, goal_checker_id, progress_checker_id, path_handler_id
        )

    def dockRobotByPose(self, dock_pose, dock_type="", nav_to_dock=True):
        return self._send(self.docking_client, dock_pose, dock_type, nav_to_dock)

    def dockRobotByID(self, dock_id, nav_to_dock=True):
        return self._send(self.docking_client, dock_id, nav_to_dock)

    def undockRobot(self, dock_type=""):
        return self._send(self.undocking_client, dock_type)

    def followObjectByTopic(self, topic, max_duration=0):
        return self._send(self.following_client, topic, max_duration)

    def followObjectByFrame(self, frame, max_duration=0):
        return self._send(self.following_client, frame, max_duration)

    def cancelTask(self):
        if _tells(self.result_future):
            self.goal_handle.cancel_goal_async()
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getFeedback(self, task=RunningTask.NONE):
        return either(self.feedback, unknown("live", "feedback of Nav2"))

    def clearPreviousState(self):
        self.feedback = None

    @reads_only
    def setTaskError(self, error_code, error_msg) -> None: ...

    def getTaskError(self):
        return _code(self.result_future), _words(self.result_future)

    def getPath(self, start, goal, planner_id="", use_start=False):
        return self._compute(self.compute_path_to_pose_client, start, goal, planner_id, use_start).path

    def getPathThroughPoses(self, start, goals, planner_id="", use_start=False):
        return self._compute(self.compute_path_through_poses_client, start, goals, planner_id, use_start).path

    def getRoute(self, start, goal, use_start=False):
        found = self._compute(self.compute_route_client, start, goal, use_start)
        return [found.path, found.route]

    def getAndTrackRoute(self, start, goal, use_start=False):
        return self._send(self.compute_and_track_route_client, start, goal, use_start)

    def smoothPath(self, path, smoother_id="", max_duration=2.0, check_for_collision=False):
        return self._compute(self.smoother_client, path, smoother_id, max_duration, check_for_collision).path

    def changeMap(self, map_filepath):
        return _tells(self._ask(self.change_maps_srv, map_filepath))

    def clearAllCostmaps(self):
        self.clearLocalCostmap()
        self.clearGlobalCostmap()

    def clearLocalCostmap(self):
        self._ask(self.clear_costmap_local_srv)

    def clearGlobalCostmap(self):
        self._ask(self.clear_costmap_global_srv)

    def clearCostmapExceptRegion(self, reset_distance):
        self._ask(self.clear_costmap_except_region_srv, reset_distance)

    def clearCostmapAroundRobot(self, reset_distance):
        self._ask(self.clear_costmap_around_robot_srv, reset_distance)

    def clearLocalCostmapAroundPose(self, pose, reset_distance):
        self._ask(self.clear_local_costmap_around_pose_srv, pose, reset_distance)

    def clearGlobalCostmapAroundPose(self, pose, reset_distance):
        self._ask(self.clear_global_costmap_around_pose_srv, pose, reset_distance)

    def getGlobalCostmap(self):
        return self._ask(self.get_costmap_global_srv).map

    def getLocalCostmap(self):
        return self._ask(self.get_costmap_local_srv).map

    def toggleCollisionMonitor(self, enable):
        self._ask(self.toggle_collision_monitor_srv, enable)

    def info(self, msg):
        self.get_logger().info(msg)

    def warn(self, msg):
        self.get_logger().warn(msg)

    def error(self, msg):
        self.get_logger().error(msg)

    def debug(self, msg):
        self.get_logger().debug(msg)

    def clearCostmapAroundPose(self, pose, reset_distance):
        self._ask(self.clear_local_costmap_around_pose_srv, pose, reset_distance)

    @reads_only
    def clearTaskError(self) -> None: ...
