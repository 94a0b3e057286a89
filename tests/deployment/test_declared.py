# SPDX-License-Identifier: Apache-2.0
"""Declared interfaces: what a program of another package creates, by its arguments and parameters. Derived by hand from the sources."""

from __future__ import annotations

import itertools

import pytest
from sampling import sample

from rosward.deployment.declared.declarations import MODELS, Declarations
from rosward.deployment.declared.effects import declared
from rosward.deployment.declared.shapes import PackageDeclaration
from rosward.domain.unknown import Cause, Origin, Reason
from rosward.domain.values import Const, Hole, Text, Unknown, Value
from rosward.effects.configuration import Configuration
from rosward.naming.options import interface_types, name_options
from rosward.ros.distro import Distro

from .declared_nodes import HERE, Rows, codes, given, lines, nodes, start, told


def test_robot_state_publisher() -> None:
    log = start("robot_state_publisher", "robot_state_publisher", ["--ros-args", "-r", "__ns:=/left"])
    assert nodes(log) == ["/left/robot_state_publisher"]
    assert lines(log) == [
        "pub /tf TFMessage",
        "pub /tf_static TFMessage",
        "pub robot_description String",
        "sub /parameter_events ParameterEvent",
        "sub joint_states JointState",
    ]
    assert codes(log) == []


def test_a_random_name_gives_way_to_the_one_of_the_launch_file() -> None:
    alone = start("tf2_ros", "static_transform_publisher", ["0", "0", "0", "0", "0", "0", "map", "odom"])
    assert nodes(alone) == ["/static_transform_publisher_*"]
    named = start("tf2_ros", "static_transform_publisher", ["--ros-args", "-r", "__node:=map_to_odom"])
    assert nodes(named) == ["/map_to_odom"]
    assert lines(named) == ["pub /tf_static TFMessage"]


def test_a_listener_keeps_the_name_of_its_own_node() -> None:
    log = start("tf2_ros", "tf2_echo", ["map", "odom", "--ros-args", "-r", "__node:=echo", "-r", "__ns:=/a"])
    assert nodes(log) == ["/a/echo", "/a/transform_listener_impl_*"]
    assert lines(log, 2) == ["sub /tf TFMessage", "sub /tf_static TFMessage"]
    options = [dict(e.options) for e in log.nodes]
    assert options[0] == {"client_library": Const("rclcpp")}
    assert options[1]["start_parameter_services"] == Const(False)
    assert options[1]["start_parameter_event_publisher"] == Const(False)


def test_a_list_of_topics_is_a_parameter() -> None:
    file: Rows = {"joint_state_publisher": {"source_list": ["arm/joints", "/gripper"]}}
    subscriptions = [
        line for line in lines(start("joint_state_publisher", "joint_state_publisher", file=file)) if "sub" in line
    ]
    assert subscriptions == [
        "sub /gripper JointState",
        "sub arm/joints JointState",
        "sub robot_description String",
    ]
    unset = start("joint_state_publisher", "joint_state_publisher")
    assert lines(unset) == ["pub joint_states JointState", "sub robot_description String"]
    unknown = start("joint_state_publisher", "joint_state_publisher", missing=True)
    assert "?sub * JointState" in lines(unknown)


def test_robot_localization_reads_its_families_until_one_is_missing() -> None:
    file: Rows = {
        "ekf_filter_node": {
            "odom0": "wheels/odom",
            "odom1": "visual/odom",
            "odom3": "never",
            "imu0": "/imu/data",
            "publish_acceleration": True,
        }
    }
    assert lines(start("robot_localization", "ekf_node", file=file)) == [
        "pub /diagnostics DiagnosticArray",
        "pub /tf TFMessage",
        "pub accel/filtered AccelWithCovarianceStamped",
        "pub odometry/filtered Odometry",
        "srv enable Empty",
        "srv reset Empty",
        "srv set_pose SetPose",
        "srv toggle ToggleFilterProcessing",
        "sub /imu/data Imu",
        "sub set_pose PoseWithCovarianceStamped",
        "sub visual/odom Odometry",
        "sub wheels/odom Odometry",
    ]


def test_keys_of_parameter_files_are_matched_with_the_final_name() -> None:
    words = ["--ros-args", "-r", "__node:=local_ekf", "-r", "__ns:=/robot"]
    file: Rows = {"/robot/local_ekf": {"odom0": "a"}, "ekf_filter_node": {"odom0": "b"}, "/*/other": {"odom0": "c"}}
    found = lines(start("robot_localization", "ekf_node", words, file=file))
    assert [line for line in found if line.endswith(" Odometry") and line.startswith("sub")] == ["sub a Odometry"]


def test_what_an_unknown_file_may_say_is_a_pattern_not_silence() -> None:
    found = lines(start("robot_localization", "ekf_node", missing=True))
    assert [line for line in found if line.startswith("?")] == [
        "?pub accel/filtered AccelWithCovarianceStamped",
        "?sub * Imu",
        "?sub * Odometry",
        "?sub * PoseWithCovarianceStamped",
        "?sub * TwistWithCovarianceStamped",
        "?sub cmd_vel Twist",
    ]


def test_an_unknown_value_keeps_its_reason() -> None:
    why = Reason(Cause.ENVIRONMENT, "ROBOT", HERE)
    word = Text(("scan_topic:=/", Hole((why,)), "/scan"))
    log = start("nav2_amcl", "amcl", ["--ros-args", "-p", word])
    (scan,) = [e for e in log.entities if interface_types(e.type) == ("sensor_msgs/msg/LaserScan",)]
    (option,) = name_options(scan.name)
    assert option.text == "/*/scan"
    assert option.reasons == (why,)


CONTROLLER: Rows = {
    "controller_server": {"FollowPath.plugin": "nav2_mppi_controller::MPPIController", "odom_topic": "/odometry"},
    "local_costmap/local_costmap": {
        "plugins": ["voxels", "inflation"],
        "voxels.plugin": "nav2_costmap_2d::VoxelLayer",
        "inflation.plugin": "nav2_costmap_2d::InflationLayer",
        "voxels.observation_sources": "scan depth",
        "voxels.scan.topic": "/scan",
        "voxels.depth.data_type": "PointCloud2",
        "voxels.publish_voxel_map": True,
    },
}


def test_one_process_can_have_several_nodes() -> None:
    log = start("nav2_controller", "controller_server", file=CONTROLLER, distro=Distro.HUMBLE)
    assert nodes(log) == ["/controller_server", "/local_costmap/local_costmap", "/transform_listener_impl_*"]
    assert lines(log) == [
        "act follow_path FollowPath",
        "pub /trajectories MarkerArray",
        "pub bond Status",
        "pub cmd_vel Twist",
        "pub transformed_global_plan Path",
        "sub /odometry Odometry",
        "sub bond Status",
        "sub speed_limit SpeedLimit",
    ]
    assert lines(log, 2) == [
        "pub bond Status",
        "pub clearing_endpoints PointCloud2",
        "pub costmap OccupancyGrid",
        "pub costmap_raw Costmap",
        "pub costmap_updates OccupancyGridUpdate",
        "pub published_footprint PolygonStamped",
        "pub voxel_grid VoxelGrid",
        "srv clear_around_local_costmap ClearCostmapAroundRobot",
        "srv clear_entirely_local_costmap ClearEntireCostmap",
        "srv clear_except_local_costmap ClearCostmapExceptRegion",
        "srv get_costmap GetCostmap",
        "sub /scan LaserScan",
        "sub bond Status",
        "sub depth PointCloud2",
        "sub footprint Polygon",
    ]
    assert codes(log) == []


def test_the_costmap_is_below_the_namespace_of_its_server() -> None:
    words = ["--ros-args", "-r", "__ns:=/robot1", "-r", "__node:=controller_server"]
    log = start("nav2_controller", "controller_server", words)
    assert nodes(log) == [
        "/robot1/controller_server",
        "/robot1/local_costmap/local_costmap",
        "/robot1/transform_listener_impl_*",
    ]
    assert "sub /robot1/map OccupancyGrid" in lines(log, 2)  # the default of map_topic


def test_since_kilted_topics_of_layers_are_those_of_the_server() -> None:
    log = start("nav2_controller", "controller_server", file=CONTROLLER, distro=Distro.KILTED)
    assert "sub /depth PointCloud2" in lines(log, 2)
    assert "pub cmd_vel TwistStamped" in lines(log)


def test_a_plugin_that_is_not_declared_is_told() -> None:
    file: Rows = {"planner_server": {"planner_plugins": ["mine"], "mine.plugin": "my_planner::Mine"}}
    log = start("nav2_planner", "planner_server", file=file)
    assert [f.message for f in told(log)] == [
        "The interface of nav2_planner/planner_server is not completely known: a planner is of a class that is not declared."
    ]
    assert codes(log) == ["RW314"]
    assert told(log)[0].place == HERE


def test_behaviors_are_actions_of_their_ids() -> None:
    file: Rows = {"behavior_server": {"behavior_plugins": ["turn"], "turn.plugin": "nav2_behaviors/Spin"}}
    log = start("nav2_behaviors", "behavior_server", file=file, distro=Distro.HUMBLE)
    assert [line for line in lines(log) if line.startswith("act")] == ["act turn Spin"]
    assert "pub cmd_vel Twist" in lines(log)


def test_the_nodes_of_a_navigator_have_names_made_of_its_own() -> None:
    log = start("nav2_bt_navigator", "bt_navigator", ["--ros-args", "-r", "__node:=nav"])
    assert nodes(log) == ["/nav", "/nav_navigate_to_pose_rclcpp_node", "/nav_navigate_through_poses_rclcpp_node"]
    assert "goal compute_path_to_pose ComputePathToPose" in lines(log, 2)


def test_a_lifecycle_manager_calls_what_it_manages() -> None:
    log = start("nav2_lifecycle_manager", "lifecycle_manager", ["--ros-args", "-p", "node_names:=[amcl, map_server]"])
    assert [line for line in lines(log) if line.startswith("cli")] == [
        "cli amcl/change_state ChangeState",
        "cli amcl/get_state GetState",
        "cli map_server/change_state ChangeState",
        "cli map_server/get_state GetState",
    ]


def test_controllers_are_nodes_of_the_controller_manager() -> None:
    file: Rows = {
        "controller_manager": {
            "update_rate": 50,
            "broadcaster.type": "joint_state_broadcaster/JointStateBroadcaster",
            "drive.type": "diff_drive_controller/DiffDriveController",
        },
        "drive": {"use_stamped_vel": False},
    }
    log = start("controller_manager", "ros2_control_node", file=file, distro=Distro.HUMBLE)
    assert nodes(log) == ["/controller_manager", "/broadcaster", "/drive"]
    assert lines(log, 3) == ["?pub /tf TFMessage", "?pub ~/odom Odometry", "?sub ~/cmd_vel_unstamped Twist"]


@pytest.mark.parametrize(
    ("words", "distro", "name", "manager"),
    [
        (["drive"], Distro.HUMBLE, "/spawner_drive", "/controller_manager"),
        (["drive", "-c", "/left/controller_manager"], Distro.HUMBLE, "/spawner_drive", "/left/controller_manager"),
        (["--inactive", "drive", "--controller-manager", "cm"], Distro.JAZZY, "/spawner_drive", "/cm"),
        (["drive", "--ros-args", "-r", "__ns:=/left"], Distro.JAZZY, "/left/spawner_drive", "/left/controller_manager"),
    ],
)
def test_a_spawner_has_the_name_of_its_controller(
    words: list[str | Value], distro: Distro, name: str, manager: str
) -> None:
    log = start("controller_manager", "spawner", words, distro=distro)
    assert nodes(log) == [name]
    assert f"cli {manager}/switch_controller SwitchController" in lines(log)
    assert dict(next(iter(log.nodes)).options)["client_library"] == Const("rclpy")


def test_image_transport_resolves_a_name_before_it_adds_to_it() -> None:
    """Since kilted; so a remap rule for the image moves the compressed one."""
    rules: list[str | Value] = [
        "--ros-args",
        "-r",
        "in:=/camera/image",
        "-r",
        "out:=/small",
        "-p",
        "in_transport:=compressed",
    ]
    assert lines(start("image_transport", "republish", rules, distro=Distro.KILTED)) == [
        "?pub /small/compressed CompressedImage",
        "?pub /small/compressedDepth CompressedImage",
        "?pub /small/theora Packet",
        "?pub /small/zstd CompressedImage",
        "pub /small Image",
        "sub /camera/image/compressed CompressedImage",
    ]
    before = start("image_transport", "republish", ["raw", "compressed", *rules], distro=Distro.HUMBLE)
    assert lines(before) == ["pub /out/compressed CompressedImage", "sub /in Image"]


def test_the_camera_info_beside_an_image() -> None:
    rule: list[str | Value] = ["--ros-args", "-r", "image:=/camera/color/image_raw"]
    assert "sub /camera/color/camera_info CameraInfo" in lines(
        start("image_proc", "image_proc::RectifyNode", rule, component=True)
    )


def test_a_relay_has_the_type_that_it_finds() -> None:
    assert lines(start("topic_tools", "relay", ["/a"])) == ["pub /a_relay -", "sub /a -"]
    assert lines(start("topic_tools", "relay", ["/a", "/b"])) == ["pub /b -", "sub /a -"]
    assert lines(start("topic_tools", "throttle", ["messages", "/a", "5.0"])) == ["pub /a_throttle -", "sub /a -"]


def test_turtlesim_took_its_messages_elsewhere() -> None:
    for distro, package in ((Distro.HUMBLE, "turtlesim"), (Distro.KILTED, "turtlesim_msgs")):
        log = start("turtlesim", "mimic", distro=distro)
        assert f"{package}/msg/Pose" in {t for e in log.entities for t in interface_types(e.type)}


def test_a_container_serves_in_its_private_namespace() -> None:
    log = start("rclcpp_components", "component_container_mt", ["--ros-args", "-r", "__node:=cameras"])
    assert nodes(log) == ["/cameras"]
    assert lines(log) == [
        "srv ~/_container/list_nodes ListNodes",
        "srv ~/_container/load_node LoadNode",
        "srv ~/_container/unload_node UnloadNode",
    ]


def test_programs_that_anybody_can_tell_what_to_do_are_told_to_be_open() -> None:
    for package, name in (
        ("rosbridge_server", "rosbridge_websocket"),
        ("rqt_graph", "rqt_graph"),
        ("micro_ros_agent", "micro_ros_agent"),
    ):
        assert codes(start(package, name)) == ["RW314"], package


def test_use_sim_time_is_a_parameter_of_every_node() -> None:
    log = start("nav2_amcl", "amcl", file={"/**": {"use_sim_time": True}}, distro=Distro.HUMBLE)
    found = {(p.address, p.name.value): p.value for p in log.parameters if isinstance(p.name, Const)}
    given = Const(True, frozenset({Origin("parameter", "use_sim_time", settled=True, given=True)}))
    assert found[1, "use_sim_time"] == found[2, "use_sim_time"] == given


# All of them

KNOWN = sorted(p.stem for p in MODELS.glob("*.yaml"))


def _starts() -> list[Configuration]:
    hole = Text(("__ns:=/", Hole((Reason(Cause.ARGUMENT, "ns", HERE),))))
    arguments = tuple(Const(w) for w in ("--ros-args", "--params-file", "/p"))
    return [
        Configuration(),
        Configuration(arguments, {"/p": None}),
        Configuration(arguments, {"/p": given({"/**": {"plugins": "wrong", "odom0": 3, "source_list": True}})}),
        Configuration((Const("--ros-args"), Const("-r"), hole, Const("-r"), Const("__node:=n"))),
        Configuration((Unknown((), "str"), Const("-d"), Unknown((), "str"))),
    ]


@pytest.mark.parametrize("package", sample(KNOWN, 4))
def test_every_declaration_is_well_formed_and_can_be_started(package: str) -> None:
    known = Declarations()
    assert known.knows(package), list(known.findings)
    (shape,) = known._of(package)
    assert isinstance(shape, PackageDeclaration)
    for distro, configuration in itertools.product(Distro, _starts()):
        for program in (*shape.executables.values(), *shape.components.values()):
            log = declared(program, configuration, HERE, known, distro)
            assert {f.code for f in log.findings} <= {"RW314"}, (program.name, list(log.findings))
            assert len(log.ends) == 1
            for effect in log.entities:
                for option in name_options(effect.name):
                    assert "{" not in option.text, (program.name, option)
                if configuration.words == () and package not in ("topic_tools", "joy_teleop"):
                    assert None not in interface_types(effect.type), (program.name, effect)
    assert not known.findings
