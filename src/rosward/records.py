# SPDX-License-Identifier: Apache-2.0
"""Data classes and named tuples that are quick to define: what the standard library gives, without looking at types or generating source text.

    @dataclass(frozen=True, slots=True)
    class Topic:
        name: str
        types: tuple[str, ...] = ()

    replace(Topic("/a"), name="/b")      Topic(name='/b', types=())

To import `dataclasses`, to have it compile six methods for each of twenty classes, and to have `typing` compile the annotations of 150 named tuples
took a fifth of the time in which a small node is analysed. For others these are data classes: `dataclasses.fields`, `replace` and `asdict` take them.
"""

from __future__ import annotations

from collections import namedtuple
from typing import TYPE_CHECKING, Any, Final

__all__ = ["FrozenError", "NamedTuple", "dataclass", "field", "replace"]


_NOTHING: Final = object()
_OF_THE_STATEMENT: Final = frozenset({"__module__", "__slots__", "__classcell__"})


class FrozenError(AttributeError):
    """A field of a frozen object is set."""


if TYPE_CHECKING:
    from dataclasses import dataclass, field, replace
    from typing import NamedTuple
else:

    class _NamedTupleMeta(type):
        """Makes a named tuple of the annotated variables of a class, which has the other variables as well."""

        def __new__(cls, name, bases, space):
            if bases == ():  # `NamedTuple` itself
                return type.__new__(cls, name, bases, space)
            types = space.pop("__annotations__", {})
            defaults = [space.pop(field) for field in types if field in space]
            made = namedtuple(name, types, defaults=defaults, module=space["__module__"])
            for key, value in space.items():
                if key not in _OF_THE_STATEMENT:
                    setattr(made, key, value)
            made.__annotations__ = types
            return made

    class NamedTuple(metaclass=_NamedTupleMeta):
        """Base of classes that are tuples with names; see `typing.NamedTuple`."""

    class _Field:
        """What is said of a field beside its type."""

        __slots__ = ("compare", "default", "make")

        def __init__(self, default: object = _NOTHING, default_factory: object = None, compare: bool = True) -> None:
            self.default = default
            self.make = default_factory
            self.compare = compare

    def field(*, default: object = _NOTHING, default_factory: object = None, compare: bool = True) -> Any:
        """A field with a default, or one that is made anew for each object; `compare`: whether it counts for equality."""
        return _Field(default, default_factory, compare)

    def dataclass(cls=None, /, *, frozen: bool = False, slots: bool = False, eq: bool = True):
        """The class with a constructor, a representation and, with `eq`, equality by its annotated variables."""
        if cls is None:
            return lambda cls: dataclass(cls, frozen=frozen, slots=slots, eq=eq)
        space = {key: value for key, value in cls.__dict__.items() if key not in ("__dict__", "__weakref__")}
        fields = {name: _field(space.pop(name, _NOTHING)) for name in cls.__annotations__}
        if slots:
            space["__slots__"] = tuple(fields)
        space |= _methods(fields, frozen=frozen)
        if eq:
            space |= _comparing(tuple([name for name, each in fields.items() if each.compare]), frozen=frozen)
        return type(cls)(cls.__name__, cls.__bases__, space)

    def replace(record, /, **changes):
        """A copy in which some fields differ."""
        cls = record.__class__
        kept = {name: getattr(record, name) for name in cls.__match_args__ if name not in changes}
        return cls(**kept, **changes)

    def _field(default):
        return default if default.__class__ is _Field else _Field(default)

    def _methods(fields, *, frozen: bool):
        names = tuple(fields)

        def __init__(self, *args, **given):  # noqa: N807
            if len(args) > len(names):
                raise TypeError(f"{self.__class__.__name__} has {len(names)} fields, and {len(args)} are given")
            for name, value in zip(names, args):  # noqa: B905  fewer may be given
                _put(self, name, value)
            for name in names[len(args) :]:
                each = fields[name]
                if name in given:
                    _put(self, name, given.pop(name))
                elif each.make is not None:
                    _put(self, name, each.make())
                elif each.default is not _NOTHING:
                    _put(self, name, each.default)
                else:
                    raise TypeError(f"{self.__class__.__name__} needs {name!r}")
            if given:
                raise TypeError(f"{self.__class__.__name__} gets {', '.join(given)} twice, or has no such field")

        def __repr__(self):  # noqa: N807
            return f"{self.__class__.__qualname__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"

        def __reduce__(self):  # noqa: N807
            return self.__class__, _values(self, names)

        methods = {"__init__": __init__, "__repr__": __repr__, "__reduce__": __reduce__}
        methods |= {"__match_args__": names, "__dataclass_fields__": _Fields(fields)}
        return methods | ({"__setattr__": _refuse, "__delattr__": _refuse} if frozen else {})

    def _comparing(names, *, frozen: bool):
        def __eq__(self, other):  # noqa: N807
            if other.__class__ is not self.__class__:
                return NotImplemented
            return _values(self, names) == _values(other, names)

        def __hash__(self):  # noqa: N807
            return hash(_values(self, names))

        return {"__eq__": __eq__, "__hash__": __hash__ if frozen else None}

    _put = object.__setattr__

    def _refuse(_self, name, *_):
        raise FrozenError(f"cannot change field {name!r}")

    def _values(record, names):
        return tuple([getattr(record, name) for name in names])

    class _Fields:
        """What `dataclasses` asks of a data class, made where it does."""

        def __init__(self, fields) -> None:
            self._fields = fields
            self._made = None

        def __get__(self, _record, cls):
            if self._made is None:
                import dataclasses

                types = cls.__annotations__
                told = [
                    (name, types[name], dataclasses.field(compare=each.compare)) for name, each in self._fields.items()
                ]
                self._made = dataclasses.make_dataclass(cls.__name__, told).__dataclass_fields__
            return self._made
