# SPDX-License-Identifier: Apache-2.0
"""`os.path`: on texts, exactly; about files, unknown: models/std_paths.py. Here are its constants."""

sep = '/'
curdir = '.'
pardir = '..'
pathsep = ':'
extsep = '.'

