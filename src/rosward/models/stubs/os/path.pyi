# SPDX-License-Identifier: Apache-2.0
"""`os.path`: on texts, exactly; about files, unknown: models/python/std/paths.py. Here are its constants."""

sep = '/'
curdir = '.'
pardir = '..'
pathsep = ':'
extsep = '.'

