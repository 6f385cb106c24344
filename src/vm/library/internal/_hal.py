# The simulation's functions. Each is looked up once, here: every look-up in `_host` makes an object.
import sys

import _host

# By setattr, which makes texts names: one key that is none makes every look-up compare texts.
_this = sys.modules["_hal"]
del sys
for _name in _host.names().split():
    setattr(_this, _name, getattr(_host, _name))


def __getattr__(name):
    # What only the runner may call is hidden later: it is never kept here.
    return getattr(_host, name)
