# SPDX-License-Identifier: Apache-2.0
"""What of C++ does the grammar of the parser not know, and what can stand in its place, as wide and with the same meaning?

goal_ = typename ActionT::Goal();        goal_ =          ActionT::Goal();
new Cell * [size]                        new Cell   [size]
public slots:                            public      :
emit changed(x);                              changed(x);
(p->*f)(1), o.*m;                        (p%~~f)(1), o%~m;
bool Lamp::*on;                          bool       *on;
int (Lamp::*f)() const noexcept;         int (*      f)()               ;
va_arg(given, char *)                    va_arg(given, 0     )
typeid(unsigned int)                     typeid($nsigned$int)
int (Lamp::*f)(int)                      int (*      f)(int)
p->template set("a", 1);                 p->         set("a", 1);
a ? b : throw E();                       a ? b : ~~~~~ E();
template<class T, int * = nullptr>       template<class T, int *_= nullptr>
decltype(f(x), void())                   decltype(      void())
decltype(declval<T>().f(), void())       decltype(declval<T>().f()% void())
x.~Tree<Node>();                         x.~Tree      ();
delete [] (v);                           delete []  v ;
delete [] *v;                            delete    *v;
v(i) = 0;                                v(i) =+0;
void (*table[])() = {f, g};              void (*table[])()   {f, g};
Lamp & on(lamps[0].on);                  Lamp & on=lamps[0].on ;
int (&row)[3] = rows[0];                 int  &row      = rows[0];
using Ts::operator()...;                 using Ts::operator()   ;
void set(T *... values)                  void set(T  ... values)
o.operator()(1), p->A::operator=(a)      o.operato$LR(1), p->A::operato$E(a)
return operator[](1);                    return operato$BK(1);
using std::sin, std::cos;                using std::sin;using  std::cos;
virtual void stop() const {};            virtual void stop() const {}
Box(const char *) -> Box<std::string>;   nothing
template class Tree<Node>;               nothing: it runs nothing
extern template int sum<int>(int);       the same
unsigned on : 2 = 1, off : 2 {0};        unsigned on     = 1, off     {0};
unsigned : 4;                                        ;

Only the declarations of one `using` become wider: what stands behind them in the same line moves.
"""

from __future__ import annotations

import re
from typing import Final

from rosward.frontends.cpp.captures import with_plain_captures
from rosward.frontends.cpp.tokens import LITERAL, blank

_TYPENAME: Final = re.compile(
    r"(?:(?<==)|(?<=\breturn))\s*\btypename\b"
    r"|(?<=[(,])\s*\btypename\b(?=[^;{}()]{0,200}::)(?=\s+[\w:]+(?:<[^;{}()]{0,200}>[\w:]*)*\s*[{(])"
)
_NEW_POINTERS: Final = re.compile(r"(?<=\bnew)([ \t]+[A-Za-z_][\w:]*)([ \t]*\*[ \t*]*)(?=\[)")
_SLOTS: Final = re.compile(r"(?:(?<=\bpublic)|(?<=\bprivate)|(?<=\bprotected))[ \t]+slots\b(?=[ \t]*:)")
_SIGNALS: Final = re.compile(r"^([ \t]*)signals(?=[ \t]*:[^:])", re.MULTILINE)
_EMIT: Final = re.compile(r"(^|[;{}):])([ \t]*)emit(?=[ \t]+[A-Za-z_])", re.MULTILINE)
_INSTANTIATION: Final = re.compile(
    r"(?:^|(?<=;))[ \t]*(?:extern[ \t]+)?template(?=[ \t\n]+[A-Za-z_])[^;{}]{0,1000};", re.MULTILINE
)
_NO_ARGUMENTS: Final = re.compile(r"(?:(?<=->)|(?<=::)|(?<=\w\.))[ \t]*\btemplate\b(?=[ \t]+\w+[ \t]*\()")

_MEMBER_POINTER: Final = re.compile(
    r"(?<=\()(\s*)((?:\w+::)+)\*(?=\s*\w*\s*(?:\[\w*\]\s*)?\)\s*\()"  # of a function
    r"|(?<=[\w>])(\s+)((?:\w+::)+)\*(?=\s*\w*\s*[;=,)>\[{])"  # of a field
)
_MEMBER_QUALIFIED: Final = re.compile(
    r"(\(\s*(?:\w+::)+\*\s*\w*\s*\)\s*\((?:[^;{}()]|\([^;{}()]{0,200}\)){0,300}\))"
    r"((?:\s*\b(?:const|volatile|noexcept)\b)+|\s*&{1,2}(?=\s*[;,)>=]))"
)
_MEMBER_OPERATOR: Final = re.compile(rf"{LITERAL}|[A-Za-z_]\w*|\.?\d(?:[eEpP][+-]|'?[\w.])*|\.\.\.|->\*|\.\*")
_VA_ARG: Final = re.compile(r"(?<=\bva_arg\()(\s*\w+\s*,\s*)([\w: ]+[*& ]*)(?=\))")
_BUILTIN = (
    r"(?:void|bool|char|short|int|long|float|double|unsigned|signed|u?int(?:8|16|32|64)_t|size_t)"
    r"(?:\s(?:char|short|int|long|double|unsigned|signed)){0,3}"
)
_TYPES: Final = re.compile(_BUILTIN)
_TYPEID: Final = re.compile(rf"(?<=\btypeid\()(\s*)({_BUILTIN})(?=\s*\))")
_FIRST: Final = "bcdfilsuv"
_THROW: Final = re.compile(r"(\?[^?;{}]{0,300}:|\?)(\s*)throw\b")

_UNNAMED: Final = re.compile(r"\*[ \t](?=\s*=\s*(?:nullptr|NULL|0)\s*[,>])")
_OPERANDS: Final = re.compile(r"\b(?:decltype|sizeof)\s*\(")
_MADE_UP: Final = re.compile(r"\s*(?:\(\s*void\s*\)\s*)?(?:std\s*::\s*)?declval<[^,;{}]{0,300}")
"""An operand before a comma that only asks whether it may stand there: the comma is read as an operator."""
_DESTRUCTOR: Final = re.compile(r"((?:\.|->)\s*~\s*\w+)(<[^;(){}]{0,200}>)(?=\s*\(\s*\))")
_DELETE: Final = re.compile(r"(\bdelete\s*\[\s*\]\s*)\(([^();]*)\)(?=\s*;)")
_DELETE_LED: Final = re.compile(r"(\bdelete\s*)(\[\s*\])(?=\s*[*&(])")
_ZERO: Final = re.compile(
    r"(?<=[;{})])(\s*(?:else\s+)?\w+\s*\(\s*[\w.]+(?:\s*[-+*/,]\s*[\w.]+){0,20}\s*\)\s*=)[ \t](?=\s*0\s*;)"
)
_TABLE: Final = re.compile(r"(\(\s*\*\s*(?:const\s+)?\w+\s*(?:\[[^\[\]{};]{0,100}\]\s*){1,3}\)\s*\(\s*\)\s*)=(?=\s*\{)")
_ROW: Final = re.compile(
    r"(\b(?:auto|bool|char|short|int|long|float|double|unsigned|signed|\w+_t)\s*)\((\s*&\s*\w+\s*)\)((?:\s*\[[^\[\]{};]{0,100}\]){1,3})(?=\s*=[^=])"
)
_DIRECT: Final = re.compile(
    r"(?<=[;{}])(\s*(?:(?:static|const|constexpr|typename)\s+)*"
    r"(?!(?:return|throw|delete|new|else|case|goto|typedef|using|friend|virtual|extern|operator|co_return|co_yield|co_await)\b)"
    r"[A-Za-z_]\w*(?:<[^;{}()]{0,200}>)?(?:::[A-Za-z_]\w*(?:<[^;{}()]{0,200}>)?){0,5}(?:\s+const)?"
    r"(?:\s*(?:\*{1,2}|&(?!&))|(?<=auto)\s?&&)\s*(?:const\s+)?[A-Za-z_]\w*)"
    r"\(((?:[^();{}]|\((?:[^();{}]|\([^();{}]{0,200}\)){0,200}\)){1,300})\)(?=\s*;)"
)
_EXPRESSION: Final = re.compile(
    r"\s*(?:[*&!~\-+\d\"'(]|(?:new|this|nullptr|NULL|true|false|(?:static|dynamic|const|reinterpret)_cast)\b"
    r"|(?!(?:bool|char|short|int|long|float|double|unsigned|signed|void|auto)\b)[A-Za-z_][\w:]*(?:\[|\.|->|\())"
)
"""How an expression begins that is no parameter."""
_BARE: Final = re.compile(r"\s*([A-Za-z_]\w*)\s*[*&]\s*[A-Za-z_]\w*$")
_NOT_BEFORE: Final = frozenset(
    {"return", "const", "volatile", "static", "extern", "new", "typename", "friend", "case", "operator", "public"}
)
"""Words before the name of a type."""
_MOST: Final = 1_000
"""So long is what `decltype` names, at most."""

_EMPTY: Final = re.compile(
    r"(\b(?!(?:decltype|alignas|noexcept|requires)\b)(?:\w+|operator\s*[^\w\s(]{1,3}|operator\s*\(\s*\))\s*\((?:[^(){};]|\([^(){};]{0,200}\)){0,1000}\)"
    r"(?:\s*(?:const|volatile|noexcept|override|final|&{1,2}))*(?:\s*->\s*[\w:<>&*, ]{1,200})?\s*\{\s*\}\s*);"
)
"""A member function with an empty body, and a needless semicolon: with that the grammar takes it for a declaration."""
_GUIDE: Final = re.compile(
    r"(?<=[;}])\s*(?:explicit\s+)?\b([A-Za-z_]\w*)\s*\([^;{}]{0,500}\)\s*->\s*\1\s*<[^;{}]{1,500}>\s*;"
)
"""A deduction guide that is no template: what it says follows from the constructors, mostly."""
_USING_LIST: Final = re.compile(
    r"((?:^|[;{}:])[ \t]*)(using\s(?!\s*namespace\b)[^;={}()\"]*,[^;={}()\"]*)(?=;)", re.MULTILINE
)
_OPERATOR: Final = re.compile(
    rf"{LITERAL}|"
    r"((?:\.|->)\s*(?:template\s+)?(?:\w+(?:<[^;(){}]{0,200}>)?\s*::\s*){0,5})"
    r"operator(\s*)(\(\s*\)|\[\s*\]|->\*?|[-+*/%^&|~!=<>]{1,3}|(?<=\s)(?:bool|int|double|float))(?=\s*\(|(?<=\))\s*<)"
)
"""An operator that is called by its name as a member."""
_OWN_OPERATOR: Final = re.compile(
    rf"{LITERAL}|((?:[;{{}}(!?+|=,]|(?<!:):(?!:)|\breturn\b)\s*)operator(\s*)"
    r"(\(\s*\)|\[\s*\]|->\*?|[-+*/%^&|~!=<>]{1,3})(?=\s*\()"
)
"""One that is called alone, as the object around has it: a declaration has a type before it."""
_USING_PACK: Final = re.compile(r"(\busing\s+\w+\s*::\s*operator\s*\(\s*\)\s*)(\.\.\.)")

_POINTERS_PACK: Final = re.compile(r"(?<=[(,])(\s*(?:const\s+)?\w+(?:\s+const)?\s*)\*(?=\s*\.\.\.\s*\w+\s*[,)])")
"""Parameters that are pointers."""

_WIDTH: Final = re.compile(r"(\b[A-Za-z_]\w*\s*)(:\s*\w+)(?=\s*[={])")
_BITS: Final = re.compile(
    r"(?<=[;{}:])(?<!::)\s*(?:(?!(?:case|class|default|enum|goto|return|struct|union|using)\b)[A-Za-z_](?:\w|::)*\s+){1,4}"
    r"(?:[A-Za-z_]\w*\s*:\s*\w+(?:\s*=[^=;,{}?]{1,100}|\s*\{[^;{}]{0,100}\}\s*|\s*),\s*){0,32}"
    r"[A-Za-z_]\w*\s*:\s*\w+(?:\s*=[^=;{}]{1,100}|\s*\{[^;{}]{0,100}\}\s*|\s*)(?=;)"
)
"""Bit-fields of one declaration, with what they begin with: the widths are left out of those, as a bit-field holds what its type holds."""
_NO_NAME: Final = re.compile(rf"(?<=[;{{}}:])\s*(?:const\s+)?(?:std::)?{_BUILTIN}\s*:\s*\w+\s*(?=;)")
"""Bits that have no name."""

THROW: Final = "~~~~~"
"""What stands for a `throw` that is an operand: an operator that nobody writes."""
OPERATOR: Final = "operato$"
"""What begins the name of a member that stands for an operator."""
TYPE: Final = "$"
"""What begins the name that stands for a builtin type, in place of its first letter."""
_SIGNS: Final = dict(zip("()[]-+*/%^&|~!=<>", "LRBKMPSDQCAOTNEUG", strict=True))
_MEANT: Final = {letter: sign for sign, letter in _SIGNS.items()}
MEMBER: Final = {".*": "%~", "->*": "%~~"}
"""What stands for the operators of pointers to members: they have the precedence of `%`, about, and what follows is an expression of any form."""


def suited(text: str) -> str:
    """The text as the grammar likes it, each character where it was (but for lists of `using`)."""
    if "typename" in text:
        text = _TYPENAME.sub(_blank, text)
    text = _members(text)
    if "va_arg" in text:
        text = _VA_ARG.sub(lambda found: f"{found[1]}0{' ' * (len(found[2]) - 1)}", text)
    if "typeid" in text:
        text = _TYPEID.sub(lambda found: found[1] + TYPE + re.sub(r"\s", TYPE, found[2][1:]), text)
    if "throw" in text:
        text = _THROW.sub(lambda found: found[1] + found[2] + THROW, text)
    if "new" in text:
        text = _NEW_POINTERS.sub(lambda found: found[1] + " " * len(found[2]), text)
    if "..." in text:
        text = _POINTERS_PACK.sub(r"\1 ", _USING_PACK.sub(r"\1   ", text))
    if "template" in text:
        text = _UNNAMED.sub("*_", text)
    if "decltype" in text or "sizeof" in text:
        text = _last_operands(text)
    if "~" in text:
        text = _DESTRUCTOR.sub(lambda found: found[1] + " " * len(found[2]), text)
    if "delete" in text:
        text = _DELETE_LED.sub(_blank_brackets, _DELETE.sub(r"\1 \2 ", text))
    if "0" in text:
        text = _ZERO.sub(r"\1+", text)
    variables: dict[str, bool] = {}
    text = _DIRECT.sub(lambda found: _initialised(found, variables), text)
    text = _ROW.sub(lambda found: f"{found[1]} {found[2]} {blank(found[3])}", _TABLE.sub(r"\1 ", text))
    if "->" in text:
        text = _GUIDE.sub(_blank, text)
    text = _NO_NAME.sub(_blank, _BITS.sub(_without_widths, text))
    text = with_plain_captures(_EMPTY.sub(r"\1 ", text))
    if "using" in text:
        text = _USING_LIST.sub(_each_used, text)
    if "slots" in text:
        text = _SLOTS.sub(_blank, text)
    if "signals" in text:
        text = _SIGNALS.sub(r"\1public ", text)
    if "emit" in text:
        text = _EMIT.sub(r"\1\2    ", text)
    if "template" in text:
        text = _NO_ARGUMENTS.sub(_blank, _INSTANTIATION.sub(_nothing, text))
    return text


def _without_widths(found: re.Match[str]) -> str:
    return _WIDTH.sub(lambda width: width[1] + blank(width[2]), found[0])


def _members(text: str) -> str:
    """The text with pointers to members, and operators that are called by their names, as other names and operators."""
    if "::*" in text:
        text = _MEMBER_QUALIFIED.sub(lambda found: found[1] + blank(found[2]), text)
        text = _MEMBER_POINTER.sub(_plain_pointer, text)
    if "->*" in text or ".*" in text:
        text = _MEMBER_OPERATOR.sub(lambda found: MEMBER.get(found[0], found[0]), text)
    if "operator" not in text:
        return text
    return _OWN_OPERATOR.sub(_named_operator, _OPERATOR.sub(_named_operator, text))


def operator_meant(name: str) -> str:
    """`operator()` for the `operato$LR` that stands for it."""
    signs = name[len(OPERATOR) :]
    return f"operator {signs}" if signs.islower() else "operator" + "".join(_MEANT.get(each, "") for each in signs)


def type_meant(name: str) -> str:
    """`unsigned int` for the `$nsigned$int` that stands for it; '' for any other name that begins so."""
    rest = name[1:].replace(TYPE, " ")
    return next((f"{first}{rest}" for first in _FIRST if _TYPES.fullmatch(f"{first}{rest}")), "")


def _named_operator(found: re.Match[str]) -> str:
    if found[3] is None:
        return found[0]
    signs = "".join(found[3].split())
    named = OPERATOR + (signs if signs.isalpha() else "".join(_SIGNS[each] for each in signs))
    return found[1] + named + " " * (len(found[0]) - len(found[1]) - len(named))


def _initialised(found: re.Match[str], variables: dict[str, bool]) -> str:
    """`T & name(a.b);` begins as `T & name = a.b;` does: the grammar takes it for a product, or a function."""
    within, type_ = found[2], _BARE.match(found[1])
    if not _EXPRESSION.match(within) or "=" in within or "..." in within or _last_comma(f"{within})", 0):
        return found[0]
    if type_ is not None and type_[1] not in variables:
        variables[type_[1]] = _is_variable(type_[1], found.string)
    is_product = type_ is not None and variables[type_[1]]
    return found[0] if is_product else f"{found[1]}={within} "


def _is_variable(name: str, text: str) -> bool:
    """Whether a text declares a variable or parameter of a name, and no type: `list * name(a.b);` is a product."""
    if name not in text or re.search(
        rf"\b(?:class|struct|union|enum|using|typename)\s+{name}\b|\btypedef\b[^;]{{0,300}}\b{name}\s*;", text
    ):
        return False
    declared = re.finditer(rf"(\w+|[>&*])\s*(?<!\w){name}\s*[;=,)]", text)
    return any(each[1] not in _NOT_BEFORE for each in declared)


def _last_operands(text: str) -> str:
    """The text where a `decltype` names nothing but what gives its type: the last of several operands."""
    pieces: list[str] = []
    position = 0
    for found in _OPERANDS.finditer(text):
        comma = _last_comma(text, found.end())
        if comma and found.start() >= position and _MADE_UP.fullmatch(text, found.end(), comma):
            pieces += (text[position : comma - 1], "%")
            position = comma
        elif comma and found.start() >= position:
            pieces += (text[position : found.end()], blank(text[found.end() : comma]))
            position = comma
    return "".join([*pieces, text[position:]])


def _last_comma(text: str, start: int) -> int:
    """Where the last operand begins between parentheses that opened before `start`; 0 where there is one, or too much."""
    depth = found = 0
    for at in range(start, min(start + _MOST, len(text))):
        character = text[at]
        if character in "\"';":
            return 0
        depth += (character in "(<[{") - (character in ")>]}" and text[at - 1] != "-")
        if depth < 0:
            return found
        if character == "," and not depth:
            found = at + 1
    return 0


def _each_used(found: re.Match[str]) -> str:
    """A declaration of its own for each name of a list; commas within template arguments part nothing."""
    pieces: list[str] = []
    depth = start = 0
    text = found[2]
    for at, character in enumerate(text):
        depth += (character == "<") - (character == ">")
        if character == "," and not depth:
            pieces.append(text[start:at])
            start = at + 1
    return found[1] + ";using ".join([*pieces, text[start:]])


def _nothing(found: re.Match[str]) -> str:
    """An explicit instantiation, blank: not where the line before goes on, as in `node->` and `template set<int>(1);`."""
    before = found.string[max(0, found.start() - 200) : found.start()].rstrip()
    return found[0] if before.endswith(("->", ".", "::")) else blank(found[0])


def _plain_pointer(found: re.Match[str]) -> str:
    space, names = (found[1], found[2]) if found[2] is not None else (found[3], found[4])
    return f"{space}*{' ' * len(names)}" if found[2] is not None else f"{space}{' ' * len(names)}*"


def _blank_brackets(found: re.Match[str]) -> str:
    return found[1] + blank(found[2])


def _blank(found: re.Match[str]) -> str:
    return blank(found[0])
