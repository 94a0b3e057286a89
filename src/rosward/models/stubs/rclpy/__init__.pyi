# SPDX-License-Identifier: Apache-2.0
"""rclpy: starting, spinning and ending; `create_node`.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import asks_all, before_sources, beside, exact_calls, overridden, spins, spun

from rclpy.context import Context as Context
from rclpy.parameter import Parameter as Parameter
from rclpy.qos import QoSProfile as QoSProfile, qos_profile_rosout_default as qos_profile_rosout_default
from rclpy.signals import SignalHandlerOptions as SignalHandlerOptions
from rclpy.signals import install_signal_handlers as install_signal_handlers
from rclpy.signals import uninstall_signal_handlers as uninstall_signal_handlers
from rclpy.task import Future as Future
from rclpy.utilities import get_default_context as get_default_context
from rclpy.utilities import get_rmw_implementation_identifier as get_rmw_implementation_identifier
from rclpy.utilities import ok as ok

asks_all(__name__)
before_sources(__name__)
exact_calls("rclpy.")


class InitContextManager:
    def __init__(self, args, context, domain_id, signal_handler_options):
        self.context = get_default_context() if context is None else context
        self.installed_signal_handlers = True
        self.context.init(args, domain_id=domain_id)

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb):
        self.context.try_shutdown()


def init(*, args=None, context=None, domain_id=None, signal_handler_options=None):
    return InitContextManager(args, context, domain_id, signal_handler_options)


def get_global_executor():
    from rclpy.executors import SingleThreadedExecutor

    return SingleThreadedExecutor()


def shutdown(*, context=None, uninstall_handlers=None):
    (get_default_context() if context is None else context).shutdown()


def try_shutdown(*, context=None, uninstall_handlers=None):
    (get_default_context() if context is None else context).try_shutdown()


def create_node(
    node_name,
    *,
    context=None,
    cli_args=None,
    namespace=None,
    use_global_arguments=True,
    enable_rosout=True,
    rosout_qos_profile=qos_profile_rosout_default,
    start_parameter_services=True,
    parameter_overrides=None,
    allow_undeclared_parameters=False,
    automatically_declare_parameters_from_overrides=False,
    enable_logger_service=False,
):
    from rclpy.node import Node

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        rosout_qos_profile=rosout_qos_profile,
        start_parameter_services=start_parameter_services,
        parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
        enable_logger_service=enable_logger_service,
    )


def _by(executor):
    """One that is not known may have several threads."""
    if executor is not None:
        from rclpy.executors import Executor

        if not isinstance(executor, Executor):
            beside()


@spins
def spin_once(node, *, executor=None, timeout_sec=None):
    spun(node)
    _by(executor)
    if overridden(executor, *_BY_SPINNING):
        executor.add_node(node)
        executor.spin_once(timeout_sec=timeout_sec)
        executor.remove_node(node)


@spins
def spin(node, executor=None):
    spun(node)
    _by(executor)
    if overridden(executor, *_BY_SPINNING):
        executor.add_node(node)
        executor.spin_once()
        executor.remove_node(node)


@spins
def spin_until_future_complete(node, future, executor=None, timeout_sec=None):
    spun(node)
    _by(executor)
    if overridden(executor, *_BY_SPINNING):
        executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec)
        executor.remove_node(node)


_BY_SPINNING = ("add_node", "spin_once", "spin_until_future_complete", "remove_node")
"""What spinning calls on an executor, which a program may override."""
