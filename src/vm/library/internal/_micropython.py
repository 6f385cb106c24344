# The device's module micropython.
import gc as _collector
import _hal
import micropython as _built_in
from micropython import const, opt_level, qstr_info, schedule, stack_use

_heap = _hal.heap
_lock = _built_in.heap_lock
_unlock = _built_in.heap_unlock
_depth = 0
_STACK_BYTES = 7680  # micropython-microbit-v2 main.c: 8 KiB, 512 bytes of them held back


def heap_lock():
    global _depth
    _lock()
    _depth += 1


def heap_unlock():
    global _depth
    if _depth:
        _unlock()
        _depth -= 1


def _free():
    """Undoes what a program did to the memory, so that our library can work."""
    while _depth:
        heap_unlock()
    _collector.enable()


def kbd_intr(chr):
    range(chr)
    _hal.kbd_intr(chr)


def mem_info(_verbose=None):
    print("stack: %u out of %u" % (min(stack_use(), _STACK_BYTES), _STACK_BYTES))
    print("GC: total: %u, used: %u, free: %u" % (_heap(0), _heap(1), _heap(2)))
    numbers = (_heap(3), _heap(4), _heap(5), _heap(6))
    print(" No. of 1-blocks: %u, 2-blocks: %u, max blk sz: %u, max free sz: %u" % numbers)


__name__ = "micropython"
