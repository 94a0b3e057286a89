# SPDX-License-Identifier: Apache-2.0
"""pydantic.alias_generators: other names for fields.

Read from pydantic 2.14.
"""
import re

def to_pascal(snake):
    return re.sub('([0-9A-Za-z])_(?=[0-9A-Z])', _first, snake.title())
def _first(match):
    return match.group(1)
def to_camel(snake):
    if re.match('^[a-z]+[A-Za-z0-9]*$', snake) and not re.search(r'\d[a-z]', snake):
        return snake
    camel = to_pascal(snake)
    return re.sub('(^_*[A-Z])', _lower, camel)
def _lower(match):
    return match.group(1).lower()
def to_snake(camel):
    snake = re.sub('([A-Z]+)([A-Z][a-z])', _joined, camel)
    snake = re.sub('([a-z])([A-Z])', _joined, snake)
    snake = re.sub('([0-9])([A-Z])', _joined, snake)
    snake = re.sub('([a-z])([0-9])', _joined, snake)
    return snake.replace('-', '_').lower()
def _joined(match):
    return match.group(1) + '_' + match.group(2)
