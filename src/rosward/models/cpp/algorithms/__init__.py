# SPDX-License-Identifier: Apache-2.0
"""`<algorithm>`, `<numeric>` and `<ranges>`: what is found, changed and made between two iterators."""
