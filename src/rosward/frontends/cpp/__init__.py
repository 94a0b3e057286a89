# SPDX-License-Identifier: Apache-2.0
"""From C++ text to the intermediate representation: preprocessor, parser, lowering."""
