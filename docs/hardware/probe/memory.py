# Probe: what memory holds. Prints bytes of objects and limits; see README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

OBJECTS = (
    "[]", "[0] * 100", "{}", "dict((i, i) for i in range(50))", "(1, 2, 3)", "'x' * 100", "bytearray(100)", "1.5",
    "2 ** 40", "3 ** 200", "Image(5, 5)", "lambda: 0", "set(range(50))", "range(5)", "object()", "list(range(100))",
    "str(3 ** 200)", "'ab' + 'cd'", "b'x' * 100",
)


def size(expression):
    """Bytes that the heap has less while the object is kept."""
    kept = [None]
    gc.collect()
    before = gc.mem_free()
    kept[0] = eval(expression)
    gc.collect()
    return before - gc.mem_free()


def largest(make):
    """The largest number that can be made something of."""
    low, high = 0, 200000
    while high - low > 64:
        middle = (low + high) // 2
        gc.collect()
        try:
            make(middle)
            low = middle
        except MemoryError:
            high = middle
    return low


def depth(level=1):
    """How deep a function can call itself."""
    try:
        return depth(level + 1)
    except RuntimeError:
        return level


print("probe;begin;memory;1;%s" % os.uname().machine)
gc.collect()
row("free at the start", "bytes", gc.mem_free())
row("free and used", "bytes", gc.mem_free() + gc.mem_alloc())
for expression in OBJECTS:
    row(expression, "bytes", size(expression))
row("largest bytearray", "bytes", largest(bytearray))
row("longest list", "items", largest(lambda count: [0] * count))
row("depth of calls", "calls", depth())
print("probe;end;memory;%d" % len(rows))
