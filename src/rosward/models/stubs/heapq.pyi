# SPDX-License-Identifier: Apache-2.0
"""`heapq`: a list in which an item is not less than the one at half its place."""

def _up(heap, start, at):
    item = heap[at]
    while at > start:
        above = (at - 1) // 2
        if not item < heap[above]:
            break
        heap[at] = heap[above]
        at = above
    heap[at] = item

def _down(heap, start):
    at, end, item = start, len(heap), heap[start]
    below = 2 * at + 1
    while below < end:
        if below + 1 < end and not heap[below] < heap[below + 1]:
            below = below + 1
        heap[at] = heap[below]
        at = below
        below = 2 * at + 1
    heap[at] = item
    _up(heap, start, at)

def heapify(x, /):
    for at in reversed(range(len(x) // 2)):
        _down(x, at)
def heappush(heap, item, /):
    heap.append(item)
    _up(heap, 0, len(heap) - 1)
def heappop(heap, /):
    last = heap.pop()
    return heapreplace(heap, last) if heap else last
def heapreplace(heap, item, /):
    first = heap[0]
    heap[0] = item
    _down(heap, 0)
    return first
def heappushpop(heap, item, /):
    if heap and heap[0] < item:
        return heapreplace(heap, item)
    return item
def nlargest(n, iterable, key=None):
    return sorted(iterable, key=key, reverse=True)[:n]
def nsmallest(n, iterable, key=None):
    return sorted(iterable, key=key)[:n]
def merge(*iterables, key=None, reverse=False):
    return iter(sorted([item for one in iterables for item in one], key=key, reverse=reverse))
