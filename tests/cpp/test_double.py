# SPDX-License-Identifier: Apache-2.0
"""Is the double of rclcpp what its documentation says? Against the real one it was compared by hand, with programs whose graph was measured."""

from __future__ import annotations

import re
from typing import Final

import pytest

from .compiled import Ran, needs_compiler, read_log, run_many
from .messages import header_name

pytestmark = [needs_compiler, pytest.mark.slow]

_HEAD: Final = """
#include "diagnostic_updater/diagnostic_updater.hpp"
#include "image_transport/image_transport.hpp"
#include "message_filters/synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "test_msgs/action/fibonacci.hpp"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"
using std_msgs::msg::String;
using std_srvs::srv::Trigger;
using test_msgs::action::Fibonacci;
"""
_CASES: Final = {
    "names are expanded": (
        """
        auto node = rclcpp::Node::make_shared("n", "cell");
        node->create_publisher<String>("a", 1);
        node->create_publisher<String>("/b", 1);
        node->create_publisher<String>("~/c", 1);
        node->create_publisher<String>("x_{node}/d", 1);
        """,
        "node /cell/n; pub /cell/a; pub /b; pub /cell/n/c; pub /cell/x_n/d",
    ),
    "invalid names throw": (
        """
        auto node = rclcpp::Node::make_shared("n");
        for (const char * name : {"", "a/", "a//b", "1a", "a-b", "{ns}/a"}) {
          try {
            node->create_publisher<String>(name, 1);
          } catch (const rclcpp::exceptions::InvalidTopicNameError &) {
            continue;
          }
          node->create_publisher<String>("not_reached", 1);
        }
        try {
          node->create_client<Trigger>("a b");
        } catch (const rclcpp::exceptions::InvalidServiceNameError &) {
          rclcpp::Node("1n");
        }
        """,
        "node /n; fails",
    ),
    "remapping, by arguments of a node": (
        """
        auto options = rclcpp::NodeOptions().arguments(
          {"--ros-args", "-r", "a:=b", "-r", "b:=c", "-r", "other:b:=d", "-r", "__ns:=/cell", "-p", "topic:=from_line"});
        auto node = std::make_shared<rclcpp::Node>("n", options);
        node->create_publisher<String>("a", 1);
        node->create_subscription<String>("b", 1, [](const String &) {});
        node->create_publisher<String>(node->declare_parameter("topic", "default"), 1);
        """,
        "node /cell/n; pub /cell/b; sub /cell/c; pub /cell/from_line",
    ),
    "sub-nodes put a prefix before what methods create": (
        """
        auto node = std::make_shared<rclcpp::Node>("n");
        auto hand = node->create_sub_node("arm")->create_sub_node("hand");
        hand->create_client<Trigger>("open");
        hand->create_publisher<String>("~/own", 1);
        rclcpp::create_publisher<String>(hand, "free", 1);
        rclcpp_action::create_client<Fibonacci>(hand, "fib");
        """,
        "node /n; sc /arm/hand/open; pub /n/own; pub /free; ac /fib",
    ),
    "callbacks in all forms": (
        """
        struct Heard : rclcpp::Node
        {
          Heard() : Node("n") {}
          void say(const std::string & what) { create_publisher<String>(what, 1); }
          void method(String::ConstSharedPtr) { say("method"); }
          void later() { say("timer"); timer->cancel(); }
          void serve(Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) { say("service"); }
          rclcpp::TimerBase::SharedPtr timer;
        };
        auto node = std::make_shared<Heard>();
        bool first = true;
        auto a = node->create_subscription<String>("a", 1, std::bind(&Heard::method, node.get(), std::placeholders::_1));
        auto b = node->create_subscription<String>("b", 1, [&first, node](String::UniquePtr m, const rclcpp::MessageInfo &) {
          if (first) node->say("unique_" + std::to_string(m->data.size()));
          first = false;
        });
        auto c = node->create_service<Trigger>("c", std::bind(&Heard::serve, node.get(), std::placeholders::_1, std::placeholders::_2));
        auto gone = node->create_subscription<String>("gone", 1, [node](const String &) { node->say("not_reached"); });
        gone.reset();
        node->timer = node->create_wall_timer(std::chrono::seconds(1), std::bind(&Heard::later, node.get()));
        rclcpp::spin(node);
        """,
        "node /n; sub /a; sub /b; ss /c; sub /gone; pub /method; pub /unique_0; pub /service; pub /timer; pub /method; pub /service",
    ),
    "requests are answered": (
        """
        auto node = std::make_shared<rclcpp::Node>("n");
        auto client = node->create_client<Trigger>("ask");
        client->wait_for_service(std::chrono::seconds(1));
        auto answer = client->async_send_request(std::make_shared<Trigger::Request>());
        if (rclcpp::spin_until_future_complete(node, answer) == rclcpp::FutureReturnCode::SUCCESS && !answer.get()->success) {
          node->create_publisher<String>("answered", 1);
        }
        client->async_send_request(std::make_shared<Trigger::Request>(), [node](rclcpp::Client<Trigger>::SharedFuture) {
          node->create_publisher<String>("called", 1);
        });
        rclcpp::spin(node);
        """,
        "node /n; sc /ask; pub /answered; pub /called",
    ),
    "actions": (
        """
        auto node = std::make_shared<rclcpp::Node>("n");
        using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;
        auto server = rclcpp_action::create_server<Fibonacci>(
          node, "~/fib", [](auto &, auto) { return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE; },
          [](auto) { return rclcpp_action::CancelResponse::ACCEPT; },
          [node](std::shared_ptr<Handle> handle) {
            std::thread([node, handle] {
              static auto once = node->create_publisher<String>("executed", 1);
              handle->succeed(std::make_shared<Fibonacci::Result>());
            }).detach();
          });
        auto client = rclcpp_action::create_client<Fibonacci>(node, "go");
        rclcpp_action::Client<Fibonacci>::SendGoalOptions options;
        options.result_callback = [node](const auto & result) {
          node->create_publisher<String>(result.code == rclcpp_action::ResultCode::SUCCEEDED ? "done" : "failed", 1);
        };
        client->async_send_goal(Fibonacci::Goal(), options);
        rclcpp::spin(node);
        """,
        "node /n; as /n/fib; ac /go; pub /done; pub /executed",
    ),
    "parameters": (
        """
        auto node = std::make_shared<rclcpp::Node>(
          "n", rclcpp::NodeOptions().parameter_overrides({{"count", 3}, {"other", "text"}}));
        std::string path = std::to_string(node->declare_parameter("count", 1));
        path = "p" + path + node->declare_parameter<std::string>("word", "w");
        try {
          node->declare_parameter<std::string>("empty");
        } catch (const rclcpp::exceptions::UninitializedStaticallyTypedParameterException &) {
          path += "_uninitialised";
        }
        try {
          node->declare_parameter("count", 1);
        } catch (const rclcpp::exceptions::ParameterAlreadyDeclaredException &) {
          path += "_twice";
        }
        try {
          node->get_parameter("absent");
        } catch (const rclcpp::exceptions::ParameterNotDeclaredException &) {
          path += "_undeclared";
        }
        try {
          node->declare_parameter("other", 1);
        } catch (const rclcpp::exceptions::InvalidParameterTypeException &) {
          path += "_type";
        }
        path += node->get_parameter_or("absent", std::string("_or"));
        node->create_publisher<String>(path, 1);
        """,
        "node /n; pub /p3w_uninitialised_twice_undeclared_type_or",
    ),
    "changes of parameters": (
        """
        auto node = std::make_shared<rclcpp::Node>("n");
        node->declare_parameter("on", false);
        auto handle = node->add_on_set_parameters_callback([&](const std::vector<rclcpp::Parameter> & changed) {
          rcl_interfaces::msg::SetParametersResult result;
          result.successful = changed.at(0).as_bool();
          return result;
        });
        for (bool on : {false, true}) {
          if (node->set_parameter({"on", on}).successful && node->get_parameter("on").as_bool()) {
            node->create_publisher<String>("on", 1);
          }
        }
        """,
        "node /n; pub /on",
    ),
    "lifecycle": (
        """
        struct Unit : rclcpp_lifecycle::LifecycleNode
        {
          Unit() : LifecycleNode("n") {}
          CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
          {
            pub = create_publisher<String>("configured", 1);
            return CallbackReturn::SUCCESS;
          }
          CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
          {
            LifecycleNode::on_activate(state);
            create_publisher<String>(pub->is_activated() ? "active" : "inactive", 1);
            throw std::runtime_error("no");
          }
          CallbackReturn on_error(const rclcpp_lifecycle::State &) override
          {
            create_publisher<String>("error", 1);
            return CallbackReturn::FAILURE;
          }
          rclcpp_lifecycle::LifecyclePublisher<String>::SharedPtr pub;
        };
        auto node = std::make_shared<Unit>();
        rclcpp::spin(node->get_node_base_interface());
        """,
        "node /n; pub /configured; pub /active; pub /error",
    ),
    "libraries on top": (
        """
        auto node = std::make_shared<rclcpp::Node>("n", "cell");
        tf2_ros::Buffer buffer(node->get_clock());
        tf2_ros::TransformListener listener(buffer, node);
        tf2_ros::StaticTransformBroadcaster broadcaster(*node);
        message_filters::Subscriber<String> left(node, "left"), right(node.get(), "right", rmw_qos_profile_default);
        using Policy = message_filters::sync_policies::ApproximateTime<String, String>;
        message_filters::Synchronizer<Policy> both(Policy(5), left, right);
        both.registerCallback([node](String::ConstSharedPtr, String::ConstSharedPtr) {
          static auto once = node->create_publisher<String>("both", 1);
        });
        diagnostic_updater::Updater updater(node);
        auto image = image_transport::create_camera_publisher(node.get(), "front/image");
        rclcpp::spin(node);
        """,
        "node /cell/n; sub /tf; sub /tf_static; pub /tf_static; sub /cell/left; sub /cell/right; pub /diagnostics; "
        "pub /cell/front/image; pub /cell/front/camera_info; pub /cell/both",
    ),
    "a loop that asks whether all is well comes to its end": (
        """
        auto node = std::make_shared<rclcpp::Node>("n");
        rclcpp::Rate rate(10);
        while (rclcpp::ok()) {
          rclcpp::spin_some(node);
          rate.sleep();
        }
        node->create_publisher<String>("after", 1);
        """,
        "node /n; pub /after",
    ),
}


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Ran]:
    texts = [
        f"{_HEAD}int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); {body} return 0; }}"
        for body, _ in _CASES.values()
    ]
    return dict(zip(_CASES, run_many(texts, tmp_path_factory.mktemp("double")), strict=True))


@pytest.mark.parametrize("name", _CASES)
def test_double(ran: dict[str, Ran], name: str) -> None:
    words = [f"{kind} {entity}" for _, kind, entity, _ in ran[name].entities] + ["fails"] * bool(ran[name].status)
    assert "; ".join(words) == re.sub(r"\s+", " ", _CASES[name][1])


def test_headers_are_named_as_by_rosidl() -> None:
    assert [
        header_name(each) for each in ("String", "LaserScan", "UInt8", "PointCloud2", "TFMessage", "CameraInfo")
    ] == [
        "string",
        "laser_scan",
        "u_int8",
        "point_cloud2",
        "tf_message",
        "camera_info",
    ]


def test_what_the_library_does_is_told_apart() -> None:
    ran = read_log(
        "x\n@double node /n\n@double pub /n /rosout rcl_interfaces/msg/Log system\nsaid\n@double sub /n /a t/msg/T\n", 0
    )
    assert ran.entities == [("/n", "node", "/n", ""), ("/n", "sub", "/a", "t/msg/T")]
    assert ran.system == [("/n", "pub", "/rosout", "rcl_interfaces/msg/Log")]
