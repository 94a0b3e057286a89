# SPDX-License-Identifier: Apache-2.0
"""launch.actions.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import REQUIRED, keep
from launch.action import Action
from launch.substitutions import LaunchConfiguration


class DeclareLaunchArgument(Action):
    def __init__(self, name, *, default_value=None, description=None, choices=None, **kwargs):
        self.name = name
        self.default_value = default_value
        self.description = description
        self.choices = choices
        keep(self, None, name=name, default=default_value, description=description, choices=choices)
        super().__init__(**kwargs)


class SetLaunchConfiguration(Action):
    def __init__(self, name, value, **kwargs):
        self.name = name
        self.value = value
        keep(self, None, name=name, value=value)
        super().__init__(**kwargs)


class UnsetLaunchConfiguration(Action):
    def __init__(self, name, **kwargs):
        self.name = name
        keep(self, None, name=name)
        super().__init__(**kwargs)


class SetEnvironmentVariable(Action):
    def __init__(self, name, value, **kwargs):
        self.name = name
        self.value = value
        keep(self, None, name=name, value=value)
        super().__init__(**kwargs)


class UnsetEnvironmentVariable(Action):
    def __init__(self, name, **kwargs):
        self.name = name
        keep(self, None, name=name)
        super().__init__(**kwargs)


class AppendEnvironmentVariable(Action):
    def __init__(self, name, value, prepend=False, separator=":", **kwargs):
        self.name = name
        self.value = value
        keep(self, None, name=name, value=value, prepend=prepend, separator=separator)
        super().__init__(**kwargs)


class PushLaunchConfigurations(Action): ...
class PopLaunchConfigurations(Action): ...
class PushEnvironment(Action): ...
class PopEnvironment(Action): ...
class ResetEnvironment(Action): ...


class ResetLaunchConfigurations(Action):
    def __init__(self, launch_configurations=None, **kwargs):
        keep(self, None, configurations=launch_configurations)
        super().__init__(**kwargs)


class EmitEvent(Action):
    def __init__(self, *, event=REQUIRED, **kwargs):
        self.event = event
        keep(self, None, event=event)
        super().__init__(**kwargs)


class Shutdown(EmitEvent):
    def __init__(self, *, reason="reason not given", **kwargs):
        super().__init__(event=reason, **kwargs)


class LogInfo(Action):
    def __init__(self, *, msg=REQUIRED, **kwargs):
        self.msg = msg
        keep(self, None, msg=msg)
        super().__init__(**kwargs)


class Log(Action):
    def __init__(self, *, msg=REQUIRED, level=REQUIRED, **kwargs):
        keep(self, None, msg=msg, level=level)
        super().__init__(**kwargs)


class LogDebug(LogInfo): ...
class LogWarning(LogInfo): ...
class LogError(LogInfo): ...


@reads_only
class ExecuteLocal(Action):
    def __init__(self, *, process_description=REQUIRED, shell=False, sigterm_timeout=5, sigkill_timeout=5, emulate_tty=False,
                 output="log", output_format="", cached_output=False, log_cmd=False, on_exit=None, respawn=False,
                 respawn_delay=None, respawn_max_retries=-1, **kwargs):
        self.process_description = process_description
        keep(self, None, process_description=process_description, shell=shell, on_exit=on_exit)
        super().__init__(**kwargs)

    def prepare(self, context) -> None: ...
    def get_stdout(self) -> str: ...
    def get_stderr(self) -> str: ...


class ExecuteProcess(ExecuteLocal):
    def __init__(self, *, cmd=REQUIRED, prefix=None, name=None, cwd=None, env=None, additional_env=None, **kwargs):
        keep(self, None, cmd=cmd, prefix=prefix, process_name=name, env=env, additional_env=additional_env)
        self.cmd = cmd
        super().__init__(process_description=None, **kwargs)


class GroupAction(Action):
    def __init__(self, actions, *, scoped=True, forwarding=True, launch_configurations=None, **left_over_kwargs):
        self.actions = actions
        keep(self, None, actions=actions, scoped=scoped, forwarding=forwarding, configurations=launch_configurations)
        super().__init__(**left_over_kwargs)

    def get_sub_entities(self): return self.actions


class IncludeLaunchDescription(Action):
    def __init__(self, launch_description_source, *, launch_arguments=None, **kwargs):
        self.launch_description_source = launch_description_source
        arguments = () if launch_arguments is None else list(launch_arguments)
        self.launch_arguments = arguments
        keep(self, None, source=launch_description_source, arguments=arguments)
        super().__init__(**kwargs)


class OpaqueFunction(Action):
    def __init__(self, *, function=REQUIRED, args=None, kwargs=None, **left_over_kwargs):
        keep(self, None, function=function, args=args, kwargs=kwargs)
        super().__init__(**left_over_kwargs)


class OpaqueCoroutine(Action):
    def __init__(self, *, coroutine=REQUIRED, args=None, kwargs=None, ignore_context=False, **left_over_kwargs):
        keep(self, None, function=coroutine, args=args, kwargs=kwargs, ignore_context=ignore_context)
        super().__init__(**left_over_kwargs)


class RegisterEventHandler(Action):
    def __init__(self, event_handler, **kwargs):
        self.event_handler = event_handler
        keep(self, None, event_handler=event_handler)
        super().__init__(**kwargs)


class UnregisterEventHandler(Action):
    def __init__(self, event_handler, **kwargs):
        self.event_handler = event_handler
        super().__init__(**kwargs)


@reads_only
class TimerAction(Action):
    def __init__(self, *, period=REQUIRED, actions=REQUIRED, cancel_on_shutdown=True, **kwargs):
        self.period = period
        self.actions = actions
        keep(self, None, period=period, actions=actions)
        super().__init__(**kwargs)

    def cancel(self) -> None: ...


class ForEach(Action):
    def __init__(self, input_values, *, function=REQUIRED, **kwargs):
        keep(self, None, values=input_values, function=function)
        super().__init__(**kwargs)


class ForLoop(Action):
    def __init__(self, length, *, function=REQUIRED, name="", **kwargs):
        keep(self, None, values=length, function=function, name=name)
        super().__init__(**kwargs)
