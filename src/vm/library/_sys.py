# The device's view of sys: MicroPython v1.18 on the micro:bit.
from sys import argv, byteorder, exit, implementation, maxsize, modules, path, print_exception

platform = "microbit"
version = "3.4.0; MicroPython v1.18 on 2023-10-30"
version_info = (3, 4, 0)
