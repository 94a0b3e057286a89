# SPDX-License-Identifier: Apache-2.0
"""Which macros are known without reading the headers of a machine?

Those of the compiler on Linux, those of well-known libraries that would hide a declaration from the parser, and those that register a class.
What they stand for is written from the documentation of the libraries.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rosward.frontends.cpp.macros import Macro, definition

_COMPILER: Final = (
    "__cplusplus 201703L", "__linux__ 1", "__linux 1", "linux 1", "__unix__ 1", "__unix 1", "unix 1", "__GNUC__ 11", "__GNUC_MINOR__ 4",
    "__GNUC_PATCHLEVEL__ 0",
    "__STDC_HOSTED__ 1", "__STDC__ 1", "__ELF__ 1", "__CHAR_BIT__ 8", "__SIZEOF_POINTER__ 8", "__LP64__ 1", "__EXCEPTIONS 1",
    "__cpp_exceptions 199711L", "__cpp_lib_filesystem 201703L", "__cpp_if_constexpr 201606L", "__cpp_lib_optional 201606L",
    "__PRETTY_FUNCTION__ __pretty_function__", "__FUNCTION__ __func__",
)  # fmt: skip
_SHARED: Final = "using SharedPtr = std::shared_ptr<X>; using ConstSharedPtr = std::shared_ptr<const X>;"
_WEAK: Final = "using WeakPtr = std::weak_ptr<X>; using ConstWeakPtr = std::weak_ptr<const X>;"
_UNIQUE: Final = "using UniquePtr = std::unique_ptr<X>;"
_MAKE_SHARED: Final = (
    "template<typename ... Args> static std::shared_ptr<X> make_shared(Args && ... args)"
    " { return std::make_shared<X>(std::forward<Args>(args) ...); }"
)
_MAKE_UNIQUE: Final = (
    "template<typename ... Args> static std::unique_ptr<X> make_unique(Args && ... args)"
    " { return std::make_unique<X>(std::forward<Args>(args) ...); }"
)
_LIBRARIES: Final = (
    f"RCLCPP_SMART_PTR_DEFINITIONS(X) {_SHARED} {_MAKE_SHARED} {_WEAK} {_UNIQUE} {_MAKE_UNIQUE}",
    f"RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(X) {_SHARED} {_MAKE_SHARED} {_WEAK} {_UNIQUE} {_MAKE_UNIQUE}",
    f"RCLCPP_SMART_PTR_ALIASES_ONLY(X) {_SHARED} {_WEAK} {_MAKE_SHARED}",
    f"RCLCPP_SHARED_PTR_DEFINITIONS(X) {_SHARED} {_MAKE_SHARED}",
    f"RCLCPP_WEAK_PTR_DEFINITIONS(X) {_WEAK}",
    f"RCLCPP_UNIQUE_PTR_DEFINITIONS(X) {_UNIQUE} {_MAKE_UNIQUE}",
    "RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(X, Y) template<> struct rclcpp::ImplicitTypeAdapter<X> : public rclcpp::TypeAdapter<X, Y> {}",
    "RCLCPP_DISABLE_COPY(X) X(const X &) = delete; X & operator=(const X &) = delete;",
    "RCLCPP_PUBLIC", "RCLCPP_LOCAL", "RCLCPP_ACTION_PUBLIC", "RCLCPP_LIFECYCLE_PUBLIC", "RCUTILS_WARN_UNUSED",
    "Q_OBJECT", "Q_GADGET", "Q_SLOTS", "Q_SIGNALS public", "Q_EMIT", "Q_INVOKABLE", "Q_DECLARE_METATYPE(X)", "Q_PROPERTY(...)", "Q_ENUM(X)",
    "Q_DISABLE_COPY(X)", "SIGNAL(X) #X", "SLOT(X) #X", "QT_BEGIN_NAMESPACE", "QT_END_NAMESPACE", "Q_SLOT", "Q_SIGNAL", "Q_NULLPTR nullptr",
    "Q_DECL_OVERRIDE override", "Q_DECL_EXPORT", "Q_INTERFACES(...)", "Q_PLUGIN_METADATA(...)", "Q_ENUMS(X)", "Q_FLAG(X)", "Q_FLAGS(X)",
    "Q_DECLARE_INTERFACE(X, Y)", "Q_CLASSINFO(X, Y)", "Q_UNUSED(X) (void)X;", "Q_FOREACH(X, Y) for (X : Y)",
    "POINT_CLOUD_REGISTER_POINT_STRUCT(...)", "POINT_CLOUD_REGISTER_POINT_WRAPPER(X, Y)",
    "PCL_ADD_POINT4D float x; float y; float z;", "PCL_ADD_NORMAL4D float normal_x; float normal_y; float normal_z;",
    "PCL_ADD_INTENSITY float intensity;", "PCL_ADD_INTENSITY_8U std::uint8_t intensity;", "PCL_ADD_INTENSITY_32U std::uint32_t intensity;",
    "PCL_ADD_RGB std::uint8_t b; std::uint8_t g; std::uint8_t r; std::uint8_t a; float rgb; std::uint32_t rgba;",
    "EIGEN_MAKE_ALIGNED_OPERATOR_NEW", "PCL_MAKE_ALIGNED_OPERATOR_NEW", "EIGEN_STRONG_INLINE inline", "EIGEN_ALWAYS_INLINE inline",
    "BOOST_FOREACH(X, Y) for (X : Y)", "BOOST_SERIALIZATION_ASSUME_ABSTRACT(X)", "BOOST_SERIALIZATION_SPLIT_MEMBER()",
    "BOOST_CLASS_EXPORT(X)",
    "BOOST_CLASS_EXPORT_KEY(X)", "BOOST_CLASS_EXPORT_IMPLEMENT(X)", "BOOST_CLASS_VERSION(X, Y)", "__attribute__(X)", "__declspec(X)", "_Pragma(X)",
    "__extension__", "__restrict__", "__restrict", "__inline__ inline",
    "BT_REGISTER_NODES(factory) extern \"C\" void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory & factory)",
)  # fmt: skip
_LENGTHS: Final[Mapping[str, str]] = {
    "8": "", "16": "", "32": "", "64": "l", "MAX": "l", "PTR": "l",
    "LEAST8": "", "LEAST16": "", "LEAST32": "", "LEAST64": "l", "FAST8": "", "FAST16": "l", "FAST32": "l", "FAST64": "l",
}  # fmt: skip
"""The formats of inttypes.h, as glibc has them for 64 bits."""

_SHORT: Final[Mapping[str, str]] = {"8": "hh", "16": "h", "LEAST8": "hh", "LEAST16": "h", "FAST8": "hh"}
_FORMATS: Final = (
    *(f'PRI{kind}{width} "{length}{kind}"' for width, length in _LENGTHS.items() for kind in "diouxX"),
    *(
        f'SCN{kind}{width} "{_SHORT.get(width, length)}{kind}"'
        for width, length in _LENGTHS.items()
        for kind in "dioux"
    ),
)

NOT_DEFINED: Final = frozenset(
    {
        "_WIN32", "_WIN64", "WIN32", "__WIN32__", "__MINGW32__", "__CYGWIN__", "_MSC_VER", "__APPLE__", "__MACH__", "__ANDROID__",
        "__FreeBSD__", "__QNX__",
        "__VXWORKS__", "__clang__", "__INTEL_COMPILER", "__CUDACC__", "__CUDA_ARCH__", "__STRICT_ANSI__", "SWIG", "DOXYGEN",
        "DOXYGEN_SHOULD_SKIP_THIS", "__cpp_concepts", "__cpp_lib_format", "__cpp_impl_coroutine", "__cpp_lib_source_location",
        "__SANITIZE_ADDRESS__",
    }
)  # fmt: skip
"""What no build on Linux with GCC and C++17 defines."""

DEPENDS: Final = frozenset(
    {
        "NDEBUG", "DEBUG", "_DEBUG", "__x86_64__", "__aarch64__", "__arm__", "__i386__", "__ARM_NEON", "__ARM_NEON__", "__SSE__",
        "__SSE2__", "__SSE4_1__",
        "__AVX__", "__AVX2__", "__OPTIMIZE__", "_OPENMP", "__BYTE_ORDER__", "__COUNTER__", "__DATE__", "__TIME__",
    }
)  # fmt: skip
"""What depends on the machine, or on how somebody builds."""

_LIBRARY_PREFIXES: Final[Mapping[str, str]] = {
    "opencv2": "CV", "cv_bridge": "CV", "boost": "BOOST", "Eigen": "EIGEN", "pcl": "PCL", "OgreVector3.h": "OGRE", "QtGlobal": "QT",
    "fmt": "FMT",
}  # fmt: skip

REGISTERING: Final = frozenset(
    {"RCLCPP_COMPONENTS_REGISTER_NODE", "PLUGINLIB_EXPORT_CLASS", "CLASS_LOADER_REGISTER_CLASS", "RCLCPP_COMPONENTS_REGISTER_NODE_WITH_EXECUTOR"}
)  # fmt: skip
"""Macros that register a class: what they register is kept, and they themselves leave the text."""

HEADERS: Final = frozenset(
    {
        "algorithm", "any", "array", "atomic", "bitset", "charconv", "chrono", "cmath", "condition_variable", "cstdint", "cstdio",
        "cstdlib", "cstring", "deque",
        "exception", "filesystem", "fstream", "functional", "future", "initializer_list", "iomanip", "iostream", "iterator", "limits",
        "list", "map", "memory",
        "mutex", "numeric", "optional", "queue", "random", "regex", "set", "shared_mutex", "sstream", "stdexcept", "string",
        "string_view", "thread", "tuple",
        "type_traits", "unordered_map", "unordered_set", "utility", "variant", "vector",
    }
)  # fmt: skip
"""Headers of the standard library, which are there."""


def predefined() -> dict[str, Macro]:
    """The macros that every file begins with."""
    made = [definition(text) for text in (*_COMPILER, *_LIBRARIES, *_FORMATS)]
    return {macro.name: macro for macro in made if macro is not None}


def macro_prefix(include: str) -> str:
    """What the macros of a library begin with, by the path of one of its headers."""
    first = include.partition("/")[0]
    return _LIBRARY_PREFIXES.get(first, first.partition(".")[0].upper())
