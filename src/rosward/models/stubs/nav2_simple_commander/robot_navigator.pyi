# SPDX-License-Identifier: Apache-2.0
"""nav2_simple_commander.robot_navigator: a node with the clients of Nav2, more of them in each distribution.

Read from ros-navigation/navigation2, branches humble (2026-06), iron (2024-10), jazzy (2026-08), kilted (2026-01), lyrical and main (2026-08).
"""

from enum import Enum

import rclpy
from _rosward import creator, either, native, reads_only, unknown
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

    def _waitForNodeToActivate(self, node_name):
        self.create_client(GetState, f"{node_name}/get_state")
        rclpy.spin_once(self)

    def _waitForInitialPose(self):
        rclpy.spin_once(self)

    def waitUntilNav2Active(self, navigator="bt_navigator", localizer="amcl"):
        if localizer != "robot_localization" or not _since("iron"):
            self._waitForNodeToActivate(localizer)
        self._waitForNodeToActivate(navigator)

    def lifecycleStartup(self):
        # Asks the running system for services of this type: those of the lifecycle managers, which are called so.
        manager = unknown("live", "names of the lifecycle managers", "str")
        self.create_client(ManageLifecycleNodes, f"/{manager}/manage_nodes")
        rclpy.spin_once(self)

    def lifecycleShutdown(self):
        self.lifecycleStartup()

    def isTaskComplete(self, task=RunningTask.NONE):
        rclpy.spin_once(self)
        return unknown("live", "state of the task")

    def getResult(self):
        return either(TaskResult.UNKNOWN, TaskResult.SUCCEEDED, TaskResult.CANCELED, TaskResult.FAILED)

    # What follows asks Nav2 over the clients above: no further entity. Messages may arrive meanwhile.

    @reads_only
    def destroyNode(self) -> None: ...

    @reads_only
    def destroy_node(self) -> None: ...

    @reads_only
    def setInitialPose(self, initial_pose) -> None: ...

    def goThroughPoses(self, poses, behavior_tree=""):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def goToPose(self, pose, behavior_tree=""):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def followWaypoints(self, poses, number_of_loops=0, goal_index=0):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def followGpsWaypoints(self, gps_poses):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def spin(self, spin_dist=1.57, time_allowance=10, disable_collision_checks=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def backup(self, backup_dist=0.15, backup_speed=0.025, time_allowance=10, disable_collision_checks=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def driveOnHeading(self, dist=0.15, speed=0.025, time_allowance=10, disable_collision_checks=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def assistedTeleop(self, time_allowance=30):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def followPath(self, path, controller_id="", goal_checker_id="", progress_checker_id="", path_handler_id=""):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def dockRobotByPose(self, dock_pose, dock_type="", nav_to_dock=True):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def dockRobotByID(self, dock_id, nav_to_dock=True):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def undockRobot(self, dock_type=""):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def followObjectByTopic(self, topic, max_duration=0):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def followObjectByFrame(self, frame, max_duration=0):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def cancelTask(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    @reads_only
    def getFeedback(self, task=RunningTask.NONE): ...

    @reads_only
    def clearPreviousState(self) -> None: ...

    @reads_only
    def setTaskError(self, error_code, error_msg) -> None: ...

    @reads_only
    def getTaskError(self): ...

    def getPath(self, start, goal, planner_id="", use_start=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getPathThroughPoses(self, start, goals, planner_id="", use_start=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getRoute(self, start, goal, use_start=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getAndTrackRoute(self, start, goal, use_start=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def smoothPath(self, path, smoother_id="", max_duration=2.0, check_for_collision=False):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def changeMap(self, map_filepath):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearAllCostmaps(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearLocalCostmap(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearGlobalCostmap(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearCostmapExceptRegion(self, reset_distance):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearCostmapAroundRobot(self, reset_distance):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearLocalCostmapAroundPose(self, pose, reset_distance):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def clearGlobalCostmapAroundPose(self, pose, reset_distance):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getGlobalCostmap(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def getLocalCostmap(self):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    def toggleCollisionMonitor(self, enable):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    @reads_only
    def info(self, msg) -> None: ...

    @reads_only
    def warn(self, msg) -> None: ...

    @reads_only
    def error(self, msg) -> None: ...

    @reads_only
    def debug(self, msg) -> None: ...

    def clearCostmapAroundPose(self, pose, reset_distance):
        rclpy.spin_once(self)
        return unknown("live", "answer of Nav2")

    @reads_only
    def clearTaskError(self) -> None: ...
