# SPDX-License-Identifier: Apache-2.0
"""`__future__`: nothing of it changes a value."""

class _Feature: ...

annotations = _Feature()
division = _Feature()
absolute_import = _Feature()
print_function = _Feature()
unicode_literals = _Feature()
generators = _Feature()
nested_scopes = _Feature()
with_statement = _Feature()
barry_as_FLUFL = _Feature()
generator_stop = _Feature()
