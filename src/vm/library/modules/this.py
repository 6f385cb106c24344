# The text of `import this`. The words are ours, not the firmware's.
from _sim import on_import as _on_import


def __init__():
    print("Small board, small program, big idea.\n")
    print("Write a line. Try it. Change it.")
    print("An error is only a hint.")
    print("Short is good. Clear is better.")
    print("What you have built, show to somebody.")


def authors():
    print("MicroPython was begun by Damien P. George. Many people brought it to the micro:bit:")
    print("their names are in the repository bbcmicrobit/micropython.")


_on_import["this"] = __init__
