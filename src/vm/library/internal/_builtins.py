# The device's module builtins. A copy: on the device it cannot be changed, and our library needs it whole.
_replaced = (help, input, open)  # by ours; the import gives the firmware's own
from builtins import *
from builtins import __build_class__, __import__

help, input, open = _replaced
__name__ = "builtins"
