# The simulation's functions. Each is looked up once, here: every look-up in `_host` makes an object.
import _host

_own = globals()
for _name in _host.names().split():
    _own[_name] = getattr(_host, _name)


def __getattr__(name):
    # What only the runner may call is hidden later: it is never kept here.
    return getattr(_host, name)
