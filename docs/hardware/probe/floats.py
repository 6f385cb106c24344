# Probe: what numbers look like. Prints expressions and their values; see README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

import math, random

VALUES = (
    "21 * 1.8 + 32", "0.1 + 0.2", "0.1 + 0.2 == 0.3", "1 / 3", "2 / 3", "1e10", "1e38 * 10", "-1e38 * 10", "1e-40",
    "1.5e-45", "123456.7", "1234567.8", "9999999.0", "16777217.0", "100.0", "1e7", "1e16", "3.14159265", "0.0001",
    "0.00001", "1e5 / 3", "7.0 // 2", "-7.5 % 2", "divmod(7.5, 2)", "round(2.5)", "round(3.14159, 2)", "int(1e10)",
    "int(-3.9)", "float('1.1')", "float('1e39')", "2 ** 0.5", "2.0 ** 100", "10 ** -3", "5e-324", "'%.3f' % 2.0005",
    "'%g' % 1e6", "'{:.10f}'.format(0.1)", "'{:e}'.format(12345.678)", "str(1.0)", "repr(1e22)", "math.pi", "math.e",
    "math.sin(1)", "math.cos(1)", "math.tan(1)", "math.exp(1)", "math.log(10)", "math.sqrt(2)", "math.atan2(1, 2)",
    "math.floor(-1.5)", "math.pow(2, 0.1)", "math.log10(2)", "math.degrees(1)", "sum((0.1, 0.1, 0.1))", "1e38 + 1e38",
    "float('nan')", "1.0 == 1", "hash(1.5)", "int('7' * 20)", "0.1 * 3",
)

print("probe;begin;floats;1;%s" % os.uname().machine)
for expression in VALUES:
    try:
        row(expression, "text", repr(eval(expression)))
    except Exception as problem:
        row(expression, "text", repr(problem))
random.seed(1)
for draw in ("random.random()", "random.random() again", "random.randint(1, 100)", "random.uniform(1, 2)"):
    row("seed 1, " + draw, "text", repr(eval(draw.replace(" again", ""))))
print("probe;end;floats;%d" % len(rows))
