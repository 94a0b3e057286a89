# SPDX-License-Identifier: Apache-2.0
"""`bisect`: where an item belongs in a sorted list."""

def bisect_left(a, x, lo=0, hi=None, *, key=None):
    at = lo
    for item in a[lo:hi]:
        if not (item if key is None else key(item)) < x:
            break
        at = at + 1
    return at
def bisect_right(a, x, lo=0, hi=None, *, key=None):
    at = lo
    for item in a[lo:hi]:
        if x < (item if key is None else key(item)):
            break
        at = at + 1
    return at
def insort_left(a, x, lo=0, hi=None, *, key=None):
    a.insert(bisect_left(a, x if key is None else key(x), lo, hi, key=key), x)
def insort_right(a, x, lo=0, hi=None, *, key=None):
    a.insert(bisect_right(a, x if key is None else key(x), lo, hi, key=key), x)
bisect = bisect_right
insort = insort_right
