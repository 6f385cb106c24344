# The modules that a program can import: the device's, not those that only this build of MicroPython has.
# Loaded last, when the library has all it needs.
import builtins
import _hal
import _files
import _builtins
import _sys
import os
from _sim import on_import as _on_import, put_word, word_at

_Module = type(builtins)
_file_size = _hal.file_size
_import_module = builtins.__import__
_HIDDEN = (
    " _asyncio asyncio binascii cmath cryptolib deflate framebuf hashlib heapq io js jsffi json marshal"
    " platform re select ssl socket uctypes vfs websocket zlib "
)
_ALIASES = {
    "builtins": "_builtins",
    "errno": "_errno",
    "gc": "_gc",
    "micropython": "_micropython",
    "sys": "_sys",
    "uerrno": "_errno",
    "uos": "os",
    "usys": "_sys",
    "utime": "time",
}


def _is_hidden(name):
    # A file of the user's may have such a name.
    top = name.split(".")[0]
    known = top[1:] if top[0] == "u" and top != "uctypes" else top
    is_ours = top in _OURS or " " + known + " " in _HIDDEN
    return is_ours and _file_size(top + ".py") < 0


def _import(name, globals=None, locals=None, names=None, _level=0):
    if _level == 0:
        # There are no packages: the file system is flat.
        if "." in name or _is_hidden(name):
            raise ImportError("no module named '" + name + "'")
        name = _ALIASES.get(name, name)
    if _level == 0 and name in _BUILT_IN and _file_size(name + ".py") < 0:
        # Whatever a program did to sys.modules and sys.path: what is built in stays.
        if name not in _loaded and name[0] != "_":
            _loaded[name] = _BUILT_IN[name]
        module = _loaded.get(name, _BUILT_IN[name])
    else:
        module = _import_module(name, globals, locals, names, _level)
    if _level == 0 and name in _on_import and _file_size(name + ".py") < 0:
        _on_import.pop(name)()
    if name in _old_names and _file_size(name + ".py") < 0:
        _rename(module, _old_names[name])
    if names and "*" in names and not isinstance(module, _Module):
        # What a program has put into sys.modules: the C code would read it as a module.
        raise ImportError("can't import name *")
    return module


def _make_way():
    """A file of the user's wins over a module of the library that is loaded already."""
    for file in os.listdir():
        if file.endswith(".py"):
            _sys.modules.pop(file[:-3], None)


def _rename(module, name):
    """Gives a module in C another name, in its table: py/obj.h, mp_obj_module_t and mp_obj_dict_t."""
    names = word_at(id(module) + 4)
    table = word_at(names + 12)
    for place in range(table, table + 8 * (word_at(names + 4) >> 3), 8):
        if word_at(place) == id("__name__"):
            put_word(place + 4, id(name))


# Modules that MicroPython has cut down were called with u before 1.19. Each is renamed by its first import, for the one of
# random draws a number.
_OLD_NAMES = "array collections random struct" if _hal.board_micropython(1) < 19 else ""
_old_names = {}
for _name in _OLD_NAMES.split():
    _old_names[_name] = _old_names["u" + _name] = "u" + _name

_loaded = _sys.modules
# The library's own parts, which are no modules of the device's.
_OURS = [name for name in _loaded if name[0] == "_" and name != "__main__"]
_BUILT_IN = {name: _loaded[name] for name in _loaded if name not in ("__main__", "_hal", "_host", "_boot", "_sim", "_repl")}
_make_way()
builtins.__import__ = _builtins.__import__ = _import
