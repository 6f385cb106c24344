# Not simulated yet: importing works as on the device, every use says so by name.
from _sim import absent


def __getattr__(name):
    absent("audio." + name)
