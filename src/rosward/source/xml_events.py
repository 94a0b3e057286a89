# SPDX-License-Identifier: Apache-2.0
"""How is an XML file of somebody else read, without its entities?

    <!DOCTYPE x [<!ENTITY a "aaaa">]>…    ->  ("The file has a document type declaration; entities are not supported.", 1)

The elements and the text go to the handlers that the caller has set; a handler may refuse the document.
"""

from __future__ import annotations

from xml.parsers.expat import ExpatError, XMLParserType, errors

__all__ = ["RefusedXmlError", "parse"]


class RefusedXmlError(Exception):
    """The document is not read any further; the message says why."""


def parse(parser: XMLParserType, data: bytes, file: str, language: str = "") -> tuple[str, int] | None:
    """What is wrong with a document, and in which line. `file` is what messages call it, `language` what it should be."""

    def doctype(*_: object) -> None:
        raise RefusedXmlError(f"{file} has a document type declaration; entities are not supported.")

    parser.StartDoctypeDeclHandler = doctype
    try:
        parser.Parse(data, True)
    except RefusedXmlError as error:
        return str(error), parser.CurrentLineNumber
    except ExpatError as error:
        return f"{file} is not well-formed{language}: {errors.messages[error.code]}.", error.lineno
    except (ValueError, LookupError) as error:  # an encoding that Python does not know
        return f"{file} cannot be read: {error}.", 1
    return None
