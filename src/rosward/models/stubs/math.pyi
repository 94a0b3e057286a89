# SPDX-License-Identifier: Apache-2.0
"""`math`: its functions are in models/python/std/numbers.py, exact on constants."""
from _rosward import pure

pure(__name__)

pi = 3.141592653589793
e = 2.718281828459045
tau = 6.283185307179586
inf = float('inf')
nan = float('nan')

