# SPDX-License-Identifier: Apache-2.0
"""rclpy.node: the node, its entities and its parameters.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import (
    array_type,
    ask,
    calls,
    create_node,
    creates,
    declare_given,
    declare_own,
    declare_parameter,
    default,
    fail_unless,
    is_given,
    is_unset,
    may_lack,
    may_refuse,
    message,
    native,
    needs_parameter,
    node_class,
    node_fqn,
    node_method,
    node_name,
    node_namespace,
    opaque,
    overridden,
    parameter,
    precise,
    raises_nothing,
    reads_only,
    refused,
    resolve_name,
    schedule,
    set_parameter,
    stops,
    undeclare_parameter,
    unknown,
    waits,
)
from rcl_interfaces.msg import ListParametersResult, ParameterDescriptor, ParameterEvent, SetParametersResult

from rclpy.callback_groups import CallbackGroup as CallbackGroup
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup as MutuallyExclusiveCallbackGroup
from rclpy.callback_groups import ReentrantCallbackGroup as ReentrantCallbackGroup
from rclpy.client import Client as Client
from rclpy.clock import Clock as Clock, ROSClock as ROSClock
from rclpy.constants import S_TO_NS as S_TO_NS
from rclpy.context import Context as Context
from rclpy.event_handler import EventHandler
from rclpy.event_handler import PublisherEventCallbacks as PublisherEventCallbacks
from rclpy.event_handler import SubscriptionEventCallbacks as SubscriptionEventCallbacks
from rclpy.exceptions import *
from rclpy.executors import Executor as Executor
from rclpy.expand_topic_name import expand_topic_name as expand_topic_name
from rclpy.guard_condition import GuardCondition as GuardCondition
from rclpy.impl.rcutils_logger import RcutilsLogger as RcutilsLogger
from rclpy.logging import get_logger as get_logger
from rclpy.logging_service import LoggingService as LoggingService
from rclpy.parameter import PARAMETER_SEPARATOR_STRING as PARAMETER_SEPARATOR_STRING
from rclpy.parameter import Parameter as Parameter
from rclpy.parameter_service import ParameterService as ParameterService
from rclpy.publisher import Publisher as Publisher
from rclpy.qos import QoSProfile as QoSProfile
from rclpy.qos import qos_profile_parameter_events as qos_profile_parameter_events
from rclpy.qos import qos_profile_rosout_default as qos_profile_rosout_default
from rclpy.qos import qos_profile_services_default as qos_profile_services_default
from rclpy.qos_overriding_options import QoSOverridingOptions as QoSOverridingOptions
from rclpy.qos_overriding_options import _declare_qos_parameters
from rclpy.service import Service as Service
from rclpy.subscription import Subscription as Subscription
from rclpy.time_source import TimeSource as TimeSource
from rclpy.timer import Rate as Rate, Timer as Timer
from rclpy.type_description_service import TypeDescriptionService as TypeDescriptionService
from rclpy.utilities import get_default_context as get_default_context

precise("create_", "declare_parameter")

HIDDEN_NODE_PREFIX = "_"


@reads_only
class _Handle:
    """What rclpy calls of C."""
    _rosward_hidden = (
        "_pybind11_conduit_v1_", "destroy_when_not_in_use", "get_action_client_names_and_types_by_node",
        "get_action_names_and_types", "get_action_server_names_and_types_by_node", "get_count_clients",
        "get_count_publishers", "get_count_services", "get_count_subscribers", "get_fully_qualified_name",
        "get_namespace", "get_node_name", "get_node_names_and_namespaces",
        "get_node_names_and_namespaces_with_enclaves", "get_parameters", "logger_name", "pointer",
    )
    def __enter__(self):
        return self
    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...


class NodeNameNonExistentError(Exception): ...


@node_class
class Node:
    PARAM_REL_TOL = 1e-6
    # What a node has beyond what is declared here; it has nothing else.
    _rosward_hidden = (
        "_allow_undeclared_parameters", "_apply_descriptor", "_apply_descriptor_and_set", "_apply_descriptors",
        "_apply_floating_point_range", "_apply_integer_range", "_call_post_set_parameters_callback",
        "_call_pre_set_parameters_callback", "_check_undeclared_parameters", "_clients", "_clock", "_context",
        "_count_clients_or_servers", "_count_publishers_or_subscribers", "_declare_parameter_common",
        "_default_callback_group", "_descriptors", "_executor_weakref", "_get_info_by_topic", "_guard_conditions",
        "_guards", "_logger", "_logger_service", "_on_set_parameters_callbacks", "_parameter_event_publisher",
        "_parameter_overrides", "_parameter_service", "_parameters_callbacks",
        "_post_set_parameters_callbacks", "_pre_set_parameters_callbacks", "_publishers", "_rate_group", "_services",
        "_set_parameters_atomically", "_set_parameters_atomically_common", "_subscriptions", "_time_source",
        "_timers", "_type_description_service", "_validate_qos_or_depth_parameter", "_validate_topic_or_service_name",
        "_waitables", "_wake_executor", "ParameterInput",
    )
    _rosward_pre = ()
    _rosward_on = ()
    _rosward_post = ()
    _rosward_lifecycle = False
    _rosward_lifecycle_services = True

    def __init__(
        self,
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
        asked = overridden(self, *_ASKED)
        create_node(
            self,
            node_name,
            asked=asked,
            context=get_default_context() if context is None else context,
            namespace=namespace,
            cli_args=cli_args,
            use_global_arguments=use_global_arguments,
            enable_rosout=enable_rosout,
            start_parameter_services=start_parameter_services,
            enable_logger_service=enable_logger_service,
            parameter_overrides=parameter_overrides,
            allow_undeclared_parameters=allow_undeclared_parameters,
            automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
            lifecycle=self._rosward_lifecycle,
            lifecycle_services=self._rosward_lifecycle_services,
        )
        if refused(node_name, "node", True):
            raise InvalidNodeNameException(node_name, "refused", 0)
        if asked:
            self._parameter_event_publisher = self.create_publisher(
                ParameterEvent, "/parameter_events", qos_profile_parameter_events
            )
        if automatically_declare_parameters_from_overrides:
            declare_given(self)
            if overridden(self, "declare_parameters"):
                given = self.get_parameters_by_prefix("")
                descriptor = ParameterDescriptor()
                entries = [(name, each.value, descriptor) for name, each in given.items()]
                may_lack(self)
                ask(self, "declare_parameters", "", entries, ignore_override=True)
        if asked:
            self._time_source = TimeSource(node=self)
            if start_parameter_services:
                self._parameter_service = ParameterService(self)
            if enable_logger_service:
                self._logger_service = LoggingService(self)
            self._type_description_service = TypeDescriptionService(self)
        declare_own(self)
        if overridden(self, "destroy_node"):
            (get_default_context() if context is None else context).track_node(self)

    # What the node has. None of these can be assigned (`self.timers = []` raises AttributeError), except `executor`.

    @property
    def publishers(self):
        return iter(unknown('live', 'rclpy.node.Node.publishers', 'list'))

    @property
    def subscriptions(self):
        return iter(unknown('live', 'rclpy.node.Node.subscriptions', 'list'))

    @property
    def clients(self):
        return iter(unknown('live', 'rclpy.node.Node.clients', 'list'))

    @property
    def services(self):
        return iter(unknown('live', 'rclpy.node.Node.services', 'list'))

    @property
    def timers(self):
        return iter(unknown('live', 'rclpy.node.Node.timers', 'list'))

    @property
    def guards(self):
        return iter(unknown('live', 'rclpy.node.Node.guards', 'list'))

    @property
    def waitables(self):
        return iter(unknown('live', 'rclpy.node.Node.waitables', 'list'))

    @property
    @reads_only
    def executor(self) -> Executor | None: ...

    @executor.setter
    def executor(self, new_executor):
        if new_executor is not None:
            new_executor.add_node(self)

    @property
    @reads_only
    def context(self) -> Context: ...

    @property
    @reads_only
    def default_callback_group(self) -> CallbackGroup: ...

    @property
    def handle(self):
        return _Handle()

    # Names

    def get_name(self):
        return node_name(self)

    def get_namespace(self):
        return node_namespace(self)

    def get_fully_qualified_name(self):
        return node_fqn(self)

    def resolve_topic_name(self, topic, *, only_expand=False):
        if only_expand:
            return expand_topic_name(topic, node_name(self), node_namespace(self))
        return resolve_name(self, topic, "topic")

    def resolve_service_name(self, service, *, only_expand=False):
        if only_expand:
            return expand_topic_name(service, node_name(self), node_namespace(self))
        return resolve_name(self, service, "service")

    @raises_nothing
    @reads_only
    def get_clock(self) -> Clock: ...
    @raises_nothing
    @reads_only
    def get_logger(self) -> RcutilsLogger: ...

    # Parameters

    def declare_parameter(self, name, value=None, descriptor=None, ignore_override=False):
        if overridden(self, "declare_parameters"):
            if value is None and descriptor is None:
                return self.declare_parameters("", [(name,)], ignore_override)[0]
            descriptor = ParameterDescriptor() if descriptor is None else descriptor
            return self.declare_parameters("", [(name, value, descriptor)], ignore_override)[0]
        return self._declare(name, value, descriptor, ignore_override)

    def _declare(self, name, value, descriptor, ignore_override):
        dynamic = descriptor is not None and descriptor.dynamic_typing
        if descriptor is not None:
            may_refuse(self)
        ask(self, "get_parameter_or", name)
        if isinstance(value, Parameter.Type):
            fail_unless(value != Parameter.Type.NOT_SET, ValueError, f"parameter {name!r} is declared of type NOT_SET: ValueError")
            return Parameter(name, None, declare_parameter(self, name, None, value, ignore_override, dynamic))
        fail_unless(
            _can_be_value(value), TypeError, f"the default of parameter {name!r} is of no type that a parameter has: TypeError"
        )
        return Parameter(name, None, declare_parameter(self, name, value, None, ignore_override, dynamic or value is None))

    def declare_parameters(self, namespace, parameters, ignore_override=False):
        declared = []
        for entry in parameters:
            fail_unless(0 < len(entry) < 4, TypeError, "a parameter is declared by a tuple of one to three elements: TypeError")
            name = f"{namespace}.{entry[0]}" if namespace else entry[0]
            value = entry[1] if len(entry) > 1 else None
            descriptor = entry[2] if len(entry) > 2 else None
            declared.append(self._declare(name, value, descriptor, ignore_override))
        return declared

    def undeclare_parameter(self, name):
        undeclare_parameter(self, name)

    @native
    def has_parameter(self, name) -> bool: ...

    def get_parameter_types(self, names):
        return [self.get_parameter_type(name) for name in names]

    def get_parameter_type(self, name):
        ask(self, "has_parameter", name)
        needs_parameter(self, name, "get_parameter_type")
        return Parameter(name, None, parameter(self, name)).type_

    def get_parameters(self, names):
        return [self.get_parameter(name) for name in names]

    def get_parameter(self, name):
        ask(self, "has_parameter", name)
        return Parameter(name, None, parameter(self, name))

    def get_parameter_or(self, name, alternative_value=None):
        ask(self, "has_parameter", name)
        if is_given(self, name):
            value = parameter(self, name)
            if not is_unset(value):
                return Parameter(name, None, value)
        if alternative_value is None:
            return Parameter(name, Parameter.Type.NOT_SET, None)
        return Parameter(
            alternative_value.name, alternative_value.type_, default("parameter", name, alternative_value.value)
        )

    @native
    def get_parameters_by_prefix(self, prefix) -> dict: ...

    _rosward_own_parameters = None

    @property
    def _parameters(self):
        """The parameters by name, unless the program puts something of its own there."""
        if self._rosward_own_parameters is None:
            return Node.get_parameters_by_prefix(self, "")
        return self._rosward_own_parameters

    @_parameters.setter
    def _parameters(self, value):
        self._rosward_own_parameters = value

    def set_parameters(self, parameter_list):
        return [self._rosward_set_all([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list):
        return self._rosward_set_all(parameter_list)

    def _rosward_set_all(self, parameters):
        modified = self._modified(parameters)
        for callback in self._rosward_on:
            result = callback(modified)
            if not result.successful:
                return result
        for new in modified:
            self._set(new)
        for callback in self._rosward_post:
            callback(modified)
        return message(SetParametersResult, "outcome")

    def _modified(self, parameters):
        if not self._rosward_pre:
            return parameters
        modified = []
        for callback in self._rosward_pre:
            modified.extend(callback(parameters))
        return modified

    def _set(self, new):
        ask(self, "has_parameter", new.name)
        set_parameter(self, new.name, new.value)
        ask(self, "get_namespace")
        ask(self, "get_name")
        ask(self, "get_parameter_or", new.name)

    @reads_only
    def list_parameters(self, prefixes, depth) -> ListParametersResult: ...

    def add_pre_set_parameters_callback(self, callback):
        may_refuse(self)
        self._rosward_pre = (*self._rosward_pre, callback)
        schedule(callback, _new_parameters(), event="parameters")

    def add_on_set_parameters_callback(self, callback):
        may_refuse(self)
        self._rosward_on = (callback, *self._rosward_on)
        schedule(callback, _new_parameters(), event="parameters")

    def add_post_set_parameters_callback(self, callback):
        self._rosward_post = (*self._rosward_post, callback)
        schedule(callback, _new_parameters(), event="parameters")

    def remove_pre_set_parameters_callback(self, callback):
        self._rosward_pre = _without(self._rosward_pre, callback)

    def remove_on_set_parameters_callback(self, callback):
        self._rosward_on = _without(self._rosward_on, callback)

    def remove_post_set_parameters_callback(self, callback):
        self._rosward_post = _without(self._rosward_post, callback)

    def describe_parameter(self, name):
        needs_parameter(self, name, "describe_parameter")
        descriptor = message(ParameterDescriptor, "descriptor")
        descriptor.name = name
        return descriptor

    def describe_parameters(self, names):
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(self, name, descriptor, alternative_value=None):
        ask(self, "has_parameter", name)
        ask(self, "describe_parameter", name)
        needs_parameter(self, name, "set_descriptor")
        may_refuse(self)
        return self.get_parameter(name).get_parameter_value()

    # Entities

    def add_waitable(self, waitable):
        if overridden(waitable, "execute", "is_ready", "take_data", "add_to_wait_set", "get_num_entities"):
            schedule(waitable.get_num_entities, event="waitable")
            schedule(waitable.add_to_wait_set, unknown("live", "wait set"), event="waitable")
            schedule(waitable.is_ready, unknown("live", "wait set"), event="waitable")
            schedule(waitable.take_data, event="waitable")
            schedule(waitable.execute, unknown("input", "data of a waitable"), event="waitable")

    @reads_only
    def remove_waitable(self, waitable) -> None: ...

    @creates("publisher", node="self", name="topic", type="msg_type", qos="qos_profile")
    def create_publisher(
        self,
        msg_type,
        topic,
        qos_profile,
        *,
        callback_group=None,
        event_callbacks=None,
        qos_overriding_options=None,
        publisher_class=Publisher,
    ):
        if qos_overriding_options is not None:
            _declare_qos_parameters("publisher", self, self.resolve_topic_name(topic), qos_profile, qos_overriding_options)
        if overridden(self, "add_waitable"):
            self.add_waitable(opaque(EventHandler))
        return publisher_class(
            self, msg_type, topic, qos_profile, event_callbacks=event_callbacks, callback_group=callback_group
        )

    @creates("subscription", node="self", name="topic", type="msg_type", qos="qos_profile", callback="callback")
    @calls("callback", event="message", args=("message:msg_type",))
    def create_subscription(
        self,
        msg_type,
        topic,
        callback,
        qos_profile,
        *,
        callback_group=None,
        event_callbacks=None,
        qos_overriding_options=None,
        raw=False,
        content_filter_options=None,
    ):
        if qos_overriding_options is not None:
            _declare_qos_parameters(
                "subscription", self, self.resolve_topic_name(topic), qos_profile, qos_overriding_options
            )
        if overridden(self, "add_waitable"):
            self.add_waitable(opaque(EventHandler))
        return Subscription(self, msg_type, topic, callback, callback_group, qos_profile, raw, event_callbacks)

    @creates("service_client", node="self", name="srv_name", type="srv_type", qos="qos_profile")
    def create_client(self, srv_type, srv_name, *, qos_profile=qos_profile_services_default, callback_group=None):
        return Client(None, self, srv_type, srv_name, qos_profile, callback_group)

    @creates("service_server", node="self", name="srv_name", type="srv_type", qos="qos_profile", callback="callback")
    @calls(
        "callback",
        event="service",
        args=("request:srv_type", "response:srv_type"),
        answers=("response", "srv_name", "srv_type"),
    )
    def create_service(
        self, srv_type, srv_name, callback, *, qos_profile=qos_profile_services_default, callback_group=None
    ):
        return Service(self, srv_type, srv_name, callback, callback_group, qos_profile)

    @node_method
    def create_timer(self, timer_period_sec, callback, callback_group=None, clock=None, autostart=True):
        return Timer(callback, callback_group, timer_period_sec, clock, autostart=autostart)

    def create_guard_condition(self, callback, callback_group=None):
        return GuardCondition(callback, callback_group)

    def create_rate(self, frequency, clock=None):
        if overridden(self, "create_timer"):
            timer = self.create_timer(1.0 / frequency, _ring, ReentrantCallbackGroup(), clock)
            return Rate(timer, context=self.context)
        return Rate(None, context=None)

    @reads_only
    def destroy_publisher(self, publisher) -> bool: ...
    @reads_only
    @stops("subscription")
    def destroy_subscription(self, subscription) -> bool: ...
    @reads_only
    def destroy_client(self, client) -> bool: ...
    @reads_only
    @stops("service")
    def destroy_service(self, service) -> bool: ...
    @reads_only
    @stops("timer")
    def destroy_timer(self, timer) -> bool: ...
    @reads_only
    def destroy_guard_condition(self, guard) -> bool: ...
    def destroy_rate(self, rate):
        ask(self, "destroy_timer", rate._timer)
        return unknown("live", "whether the rate was there", "bool")

    def destroy_node(self):
        ask(self, "destroy_publisher", unknown("live", "publisher of the node"))
        ask(self, "destroy_subscription", unknown("live", "subscription of the node"))
        ask(self, "destroy_client", unknown("live", "client of the node"))
        ask(self, "destroy_service", unknown("live", "service of the node"))
        ask(self, "destroy_timer", unknown("live", "timer of the node"))
        ask(self, "destroy_guard_condition", unknown("live", "guard condition of the node"))

    # The running system, which nobody knows before it runs

    def get_publisher_names_and_types_by_node(self, node_name, node_namespace, no_demangle=False):
        return unknown("live", "publishers of a node")

    def get_subscriber_names_and_types_by_node(self, node_name, node_namespace, no_demangle=False):
        return unknown("live", "subscriptions of a node")

    def get_service_names_and_types_by_node(self, node_name, node_namespace):
        return unknown("live", "services of a node")

    def get_client_names_and_types_by_node(self, node_name, node_namespace):
        return unknown("live", "service clients of a node")

    def get_topic_names_and_types(self, no_demangle=False):
        return unknown("live", "topics of the system")

    def get_service_names_and_types(self):
        return unknown("live", "services of the system")

    def get_node_names(self):
        return unknown("live", "nodes of the system")

    def get_fully_qualified_node_names(self):
        ask(self, "get_node_names_and_namespaces")
        return unknown("live", "nodes of the system")

    def get_node_names_and_namespaces(self):
        return unknown("live", "nodes of the system")

    def get_node_names_and_namespaces_with_enclaves(self):
        return unknown("live", "nodes of the system")

    @reads_only
    def count_publishers(self, topic_name) -> int: ...
    @reads_only
    def count_subscribers(self, topic_name) -> int: ...
    @reads_only
    def count_clients(self, service_name) -> int: ...
    @reads_only
    def count_services(self, service_name) -> int: ...

    def get_publishers_info_by_topic(self, topic_name, no_mangle=False):
        return unknown("live", "publishers of a topic")

    def get_subscriptions_info_by_topic(self, topic_name, no_mangle=False):
        return unknown("live", "subscriptions of a topic")

    @waits
    def wait_for_node(self, fully_qualified_node_name, timeout):
        ask(self, "get_fully_qualified_node_names")
        return unknown("live", "whether the node is there", "bool")

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb):
        ask(self, "destroy_node")


_ASKED = (
    "create_publisher", "create_subscription", "create_service", "destroy_subscription", "get_name", "get_logger",
    "declare_parameter", "declare_parameters", "has_parameter", "get_parameter", "get_parameters",
    "get_parameter_type", "get_parameter_types", "describe_parameter", "describe_parameters", "list_parameters",
    "set_parameters_atomically", "get_parameter_or", "add_on_set_parameters_callback",
)
"""What rclpy calls on a node that it makes, at once or when somebody asks one of its services."""


def _ring():
    """The callback of a rate's timer."""
    return None


def _can_be_value(value):
    """Whether a parameter can have the value, by its type."""
    if isinstance(value, (list, tuple)):
        return array_type(value) != ""
    return not isinstance(value, (dict, set, frozenset, bytes, bytearray, complex))


def _without(callbacks, callback):
    """Those that are called when the code itself sets a parameter; another node may have set one while this callback was there."""
    left = list(callbacks)
    left.remove(callback)
    return tuple(left)


def _new_parameters():
    """What a callback for parameters sees: any number of them, of any name and value."""
    return [
        Parameter(unknown("parameter", "name, set when it runs"), None, unknown("parameter", "value, set when it runs"))
        for _ in unknown("parameter", "set when it runs")
    ]
