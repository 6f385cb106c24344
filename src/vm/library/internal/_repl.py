# Runs what the REPL has collected. The simulation handles what is typed and shown (src/vm/run/repl.ts).
import __main__
import builtins
import sys

import _hal
from _micropython import _free as free

_scope = __main__.__dict__
_wait = _hal.repl
_text = _hal.repl_text
_names = _hal.repl_names
_run = _hal.repl_run
_fail = _hal.repl_fail
_STATEMENT = 1
_NAMES = 3
_REBOOT = 4


def cause(end):
    """What ended the program with this SystemExit: the error of a callback (_sim.py), or None for its own exit."""
    if len(end.args) == 2 and isinstance(end.args[1], BaseException) and not isinstance(end.args[1], SystemExit):
        return end.args[1]
    return None


def serve():
    """Answers until the board is to reboot."""
    while True:
        try:
            kind = _wait()
            if kind == _REBOOT:
                return
            if kind == _NAMES:
                _names(_complete(_text()))
            elif kind is not None and _execute(kind == _STATEMENT):
                return
        except SystemExit as end:
            # The error of a callback, while nothing else ran.
            _show(cause(end) or end)
        except BaseException as error:
            _show(error)


def _execute(is_statement):
    """True when the program wants to leave."""
    failure = None
    try:
        code = compile(_text(), "<stdin>", "single" if is_statement else "exec")
        _run(True)
        exec(code, _scope)
        _run(False)
        return False
    except SystemExit as end:
        failure = cause(end)
        if failure is None:
            return True
    except BaseException as error:
        failure = error
    code = None
    _run(False)
    _show(failure)
    return False


def _show(error):
    free()
    _fail()
    sys.print_exception(error)


def _complete(path):
    if not path:
        return " ".join(_scope)
    try:
        first, *rest = path.split(".")
        thing = _scope[first] if first in _scope else getattr(builtins, first)
        for name in rest:
            thing = getattr(thing, name)
        return " ".join(dir(thing))
    except Exception:
        return ""


_MODULES = (
    "antigravity array audio builtins collections errno gc log love machine math microbit micropython music neopixel os"
    " power radio random speech struct sys this time"
)
_builtin_help = builtins.help


def help(*args):
    if not args:
        print(
            "MicroPython waits for what you type, and answers at once. Try:\n"
            "  display.show(Image.HAPPY)\n"
            "  button_a.is_pressed()\n"
            "  temperature()\n\n"
            "Arrow up and down: lines you typed before. Tab: ends a word, di becomes display.\n"
            "  dir()            all names that are known here\n"
            "  dir(thing)       what a thing has\n"
            "  help(thing)      what it is\n"
            "  help('modules')  what can be imported\n\n"
            "Ctrl-C  stops what is running\n"
            "Ctrl-D  on an empty line: starts the program anew\n"
            "Ctrl-E  takes a pasted program, until Ctrl-D"
        )
    elif args[0] == "modules":
        names = sorted(_MODULES.split() + [_module for _module in (_board_module,) if _module != "microbit"])
        rows = (len(names) + 3) // 4
        for row in range(rows):
            print("".join("%-18s" % name for name in names[row::rows]).strip())
        print("Plus any modules on the filesystem")
    else:
        _builtin_help(*args)


_board_module = _hal.board_module(0)
builtins.help = help
