# The device's module gc. It counts the program's 64 KiB alone: our library's part of the heap is always full (heap.ts).
from gc import collect, disable, enable, isenabled, mem_free as _mem_free, threshold

_BYTES = 64512  # what the device's heap has in all
_PROGRAM_BYTES = 64352


def mem_alloc():
    return _BYTES - mem_free()


def mem_free():
    # A little more is free while an error is dealt with.
    return min(_mem_free(), _PROGRAM_BYTES)


__name__ = "gc"
