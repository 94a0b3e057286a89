# SPDX-License-Identifier: Apache-2.0
"""`xml.etree.ElementTree`: what text says that stands in the program, or in a file of the sources (models/python/std/trees.py).

Read in CPython 3.13, `Lib/xml/etree/ElementTree.py` and `ElementPath.py`. What a text says that is not known is unknown.
"""
from _rosward import ask, native, reads_only, unknown
import os

@native
def _tree(text): ...

class ParseError(SyntaxError): ...

class Element:
    def __init__(self, tag, attrib={}, **extra):
        self.tag = tag
        self.attrib = {**attrib, **extra}
        self.text = None
        self.tail = None
        self._inside = []
    def get(self, key, default=None):
        return self.attrib.get(key, default)
    def set(self, key, value):
        self.attrib[key] = value
    def keys(self):
        return self.attrib.keys()
    def items(self):
        return self.attrib.items()
    def __iter__(self):
        return iter(self._inside)
    def __len__(self):
        return len(self._inside)
    def __getitem__(self, index):
        return self._inside[index]
    def append(self, subelement, /):
        self._inside.append(subelement)
    def extend(self, elements, /):
        self._inside.extend(elements)
    def insert(self, index, subelement, /):
        self._inside.insert(index, subelement)
    def remove(self, subelement, /):
        self._inside = [each for each in self._inside if each is not subelement]
    def clear(self):
        self.attrib = {}
        self._inside = []
        self.text = None
        self.tail = None
    def iter(self, tag=None):
        return iter(_below(self, tag, True))
    def itertext(self):
        return iter(_texts(self))
    def findall(self, path, namespaces=None):
        return _found(self, path, namespaces)
    def iterfind(self, path, namespaces=None):
        return iter(_found(self, path, namespaces))
    def find(self, path, namespaces=None):
        for each in _found(self, path, namespaces):
            return each
        return None
    def findtext(self, path, default=None, namespaces=None):
        for each in _found(self, path, namespaces):
            return each.text or ''
        return default

def _fits(element, tag):
    return tag is None or tag == '*' or element.tag == tag
def _below(element, tag, itself):
    found = [element] if itself and _fits(element, tag) else []
    for each in element._inside:
        found += _below(each, tag, True)
    return found
def _texts(element):
    found = [element.text] if element.text else []
    for each in element._inside:
        found += _texts(each)
        if each.tail:
            found.append(each.tail)
    return found

def _some():
    """Elements of which nothing is known."""
    return [_unknown_element() for _ in unknown('operation', 'path of elements', 'list')]
def _unknown_element():
    return unknown('file', 'XML')

def _found(element, path, namespaces):
    """What a path leads to: names, `.`, `*`, `//`, and `[@name]`, `[@name='value']`, `[number]` behind them."""
    here, below = [element], False
    for step in _steps(path):
        if step == '':
            below = True
            continue
        if step == '.':
            continue
        name, _, rest = step.partition('[')
        if name == '..' or '(' in step:
            return _some()
        if ':' in name and name[0] != '{':
            prefix, _, last = name.partition(':')
            if namespaces is None or prefix not in namespaces:
                return _some()
            name = '{' + namespaces[prefix] + '}' + last
        found = []
        for each in here:
            inside = _below(each, name, False) if below else [one for one in each._inside if _fits(one, name)]
            for test in rest.split('[') if rest else []:
                inside = _tested(inside, test.rstrip(']'))
            found += inside
        here, below = found, False
    return here

def _steps(path):
    """The steps of a path: a slash in braces or in quotes is none of those between them."""
    if '{' in path or "'" in path or '"' in path:
        found, step, closing = [], '', ''
        for character in path:
            if closing:
                if character == closing:
                    closing = ''
            elif character == '{':
                closing = '}'
            elif character == "'" or character == '"':
                closing = character
            elif character == '/':
                found.append(step)
                step = ''
                continue
            step = step + character
        return found + [step]
    return path.split('/')

def _tested(elements, test):
    if test.isdigit():
        return elements[int(test) - 1:int(test)]
    if test == 'last()':
        return elements[-1:]
    name, equals, value = test.partition('=')
    wanted = value.strip('"\'')
    if name[:1] == '@':
        if not equals:
            return [each for each in elements if name[1:] in each.attrib]
        if name[-1:] == '!':
            return [each for each in elements if name[1:-1] in each.attrib and each.attrib[name[1:-1]] != wanted]
        return [each for each in elements if each.attrib.get(name[1:]) == wanted]
    if not equals:
        return [each for each in elements if any(one.tag == name for one in each._inside)]
    if name == '.':
        return [each for each in elements if ''.join(_texts(each)) == wanted]
    return [each for each in elements if any(one.tag == name and ''.join(_texts(one)) == wanted for one in each._inside)]

def _made(parts):
    element = Element(parts[0], parts[1])
    element.text = parts[2]
    element.tail = parts[3]
    for each in parts[4]:
        element._inside.append(_made(each))
    return element

def fromstring(text, parser=None):
    found = _tree(text)
    return unknown('file', 'XML') if found is None else _made(found)
XML = fromstring
def fromstringlist(sequence, parser=None):
    return fromstring(''.join(sequence))
def XMLID(text, parser=None):
    return (fromstring(text), unknown('file', 'XML', 'dict'))

class ElementTree:
    def __init__(self, element=None, file=None):
        self._root = element
        if file is not None:
            self.parse(file)
    def getroot(self):
        return self._root
    def parse(self, source, parser=None):
        self._root = fromstring(open(source).read() if isinstance(source, (str, os.PathLike)) else source.read())
        return self._root
    def iter(self, tag=None):
        return self._root.iter(tag)
    def find(self, path, namespaces=None):
        return self._root.find(_from_root(path), namespaces)
    def findtext(self, path, default=None, namespaces=None):
        return self._root.findtext(_from_root(path), default, namespaces)
    def findall(self, path, namespaces=None):
        return self._root.findall(_from_root(path), namespaces)
    def iterfind(self, path, namespaces=None):
        return self._root.iterfind(_from_root(path), namespaces)
    def write(self, file_or_filename, encoding=None, xml_declaration=None, default_namespace=None, method=None, *, short_empty_elements=True):
        ask(file_or_filename, 'write', unknown('call', 'text that a library writes', 'str'))

def _from_root(path):
    return '.' + path if path[:1] == '/' else path
def parse(source, parser=None):
    made = ElementTree()
    made.parse(source, parser)
    return made
def SubElement(parent, tag, attrib={}, **extra):
    made = Element(tag, attrib, **extra)
    parent.append(made)
    return made
@reads_only
def tostring(element, encoding=None, method=None, *, xml_declaration=None, default_namespace=None, short_empty_elements=True): ...
def iselement(element):
    return hasattr(element, 'tag')
@reads_only
def indent(tree, space='  ', level=0) -> None: ...
@reads_only
def dump(elem) -> None: ...
@reads_only
def register_namespace(prefix, uri) -> None: ...
def iterparse(source, events=None, parser=None):
    return iter([(unknown('file', 'XML', 'str'), unknown('file', 'XML')) for _ in unknown('file', 'XML', 'list')])
@reads_only
def Comment(text=None): ...
