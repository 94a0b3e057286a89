# SPDX-License-Identifier: Apache-2.0
"""attr.filters.

Read from attrs 26.1.
"""

def include(*what):
    def keeps(attribute, value):
        return type(value) in what or attribute.name in what or attribute in what
    return keeps
def exclude(*what):
    def keeps(attribute, value):
        return not (type(value) in what or attribute.name in what or attribute in what)
    return keeps
