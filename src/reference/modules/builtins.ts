import { absent, exception, fn, module, withWordsOf, type, value, values } from '../table';
import { boolType, bytearrayType, bytesType, floatType, intType, strType } from './plain-types';
import { dictType, frozensetType, listType, rangeType, setType, tupleType } from './container-types';

const functions = {
  print: fn("(*values, sep: str = ' ', end: str = '\\n') -> None"),
  input: fn("(prompt: str = '') -> str"),
  len: fn('(values) -> int'),
  abs: fn('(x: float) -> float'),
  min: fn('(*values, key: function | None = None)', '(values: list, *, key: function | None = None, default=None)'),
  max: fn('(*values, key: function | None = None)', '(values: list, *, key: function | None = None, default=None)'),
  sum: fn('(values: list, start=0) -> float'),
  round: fn('(x: float) -> int', '(x: float, ndigits: int) -> float'),
  pow: fn('(base: float, exp: float) -> float'),
  divmod: fn('(a: int, b: int) -> tuple[int, int]'),
  sorted: fn('(values: list, *, key: function | None = None, reverse: bool = False) -> list'),
  any: fn('(values: list) -> bool'),
  all: fn('(values: list) -> bool'),
  chr: fn('(code: int) -> str'),
  ord: fn('(character: str) -> int'),
  bin: fn('(x: int) -> str'),
  hex: fn('(x: int) -> str'),
  oct: fn('(x: int) -> str'),
  open: fn("(filename: str, mode: str = 'r') -> file"),
  iter: fn('(values: list)'),
  next: fn('(iterator)'),
  isinstance: fn('(value, type: type | tuple) -> bool'),
  issubclass: fn('(type: type, base: type | tuple) -> bool'),
  callable: fn('(value) -> bool'),
  hasattr: fn('(object, name: str) -> bool'),
  getattr: fn('(object, name: str)', '(object, name: str, default)'),
  setattr: fn('(object, name: str, value) -> None'),
  delattr: fn('(object, name: str) -> None'),
  dir: fn('() -> list[str]', '(object) -> list[str]'),
  help: fn('() -> None', '(object) -> None'),
  id: fn('(object) -> int'),
  hash: fn('(object) -> int'),
  repr: fn('(value) -> str'),
  eval: fn('(source: str)'),
  exec: fn('(source: str) -> None'),
  globals: fn('() -> dict'),
  locals: fn('() -> dict'),
  __import__: fn('(name: str)'),
  breakpoint: absent(fn('() -> None')),
  aiter: absent(fn('(values)')),
  anext: absent(fn('(iterator)')),
};

const file = type([], {
  read: fn('(size: int = -1) -> str'),
  readline: fn('(size: int = -1) -> str'),
  readinto: fn('(buf: bytearray) -> int'),
  write: fn('(text: str | bytes) -> int'),
  close: fn('() -> None'),
  name: fn('() -> str'),
  writable: fn('() -> bool'),
});

const types = {
  int: intType,
  float: floatType,
  str: strType,
  bool: boolType,
  bytes: bytesType,
  bytearray: bytearrayType,
  list: listType,
  tuple: tupleType,
  dict: dictType,
  set: setType,
  frozenset: frozensetType,
  range: rangeType,
  enumerate: type(['(values: list, start: int = 0)'], {}),
  zip: type(['(*values: list)'], {}),
  map: type(['(function: function, *values: list)'], {}),
  filter: type(['(function: function, values: list)'], {}),
  reversed: type(['(values: list)'], {}),
  memoryview: type(['(buffer: bytes)'], {}),
  complex: type(['(real: float = 0, imag: float = 0)'], values('float', ['real', 'imag'])),
  object: type(['()'], {}),
  type: type(['(object)'], {}),
  super: type(['()'], {}),
  property: type(['(get: function)'], {
    getter: fn('(get: function) -> property'),
    setter: fn('(set: function) -> property'),
    deleter: fn('(delete: function) -> property'),
    fget: absent(value('function')),
    fset: absent(value('function')),
    fdel: absent(value('function')),
  }),
  staticmethod: type(['(function: function)'], {}),
  classmethod: type(['(function: function)'], {}),
  slice: type([], {
    start: absent(value('int')),
    stop: absent(value('int')),
    step: absent(value('int')),
    indices: absent(fn('(length: int) -> tuple[int, int, int]')),
  }),
  // Programs meet these types, but have no name for them.
  file: absent(file),
  generator: absent(type([], { send: fn('(value)'), close: fn('() -> None'), throw: fn('(error)') })),
  memory: absent(type([], {})),
  function: absent(type([], {})),
  ellipsis: absent(type([], {})),
  Ellipsis: value('ellipsis'),
  NotImplemented: absent(value('object')),
};

/** Names that only the exceptions of desktop Python have. */
const desktopOnly = (...names: string[]) =>
  Object.fromEntries(names.map((name) => [name, absent(withWordsOf('builtins.desktopOnly', value('object')))]));

const exceptions = {
  BaseException: exception('object', {
    args: value('tuple'),
    ...desktopOnly('with_traceback'),
  }),
  Exception: exception('BaseException'),
  ArithmeticError: exception('Exception'),
  AssertionError: exception('Exception'),
  AttributeError: exception('Exception', desktopOnly('name', 'obj')),
  EOFError: exception('Exception'),
  GeneratorExit: exception('BaseException'),
  ImportError: exception('Exception', desktopOnly('name', 'path', 'msg')),
  IndentationError: exception('SyntaxError'),
  IndexError: exception('LookupError'),
  KeyboardInterrupt: exception('BaseException'),
  KeyError: exception('LookupError'),
  LookupError: exception('Exception'),
  MemoryError: exception('Exception'),
  NameError: exception('Exception', desktopOnly('name')),
  NotImplementedError: exception('RuntimeError'),
  OSError: exception('Exception', {
    errno: value('int'),
    ...desktopOnly('strerror', 'filename', 'filename2', 'winerror'),
  }),
  OverflowError: exception('ArithmeticError'),
  RuntimeError: exception('Exception'),
  StopAsyncIteration: exception('Exception', { value: withWordsOf('builtins.StopIteration.value', value('object')) }),
  StopIteration: exception('Exception', { value: value('object') }),
  SyntaxError: exception(
    'Exception',
    desktopOnly('msg', 'lineno', 'offset', 'text', 'filename', 'end_lineno', 'end_offset'),
  ),
  SystemExit: exception('BaseException', desktopOnly('code')),
  TypeError: exception('Exception'),
  UnicodeError: exception('ValueError'),
  ValueError: exception('Exception'),
  ZeroDivisionError: exception('ArithmeticError'),
  FloatingPointError: absent(exception('ArithmeticError')),
  TabError: absent(exception('IndentationError')),
  WindowsError: absent(exception('OSError')),
};

/**
 * Names that need no import. Source: micropython v1.18, py/modbuiltins.c, with the settings of micropython-microbit-v2's
 * mpconfigport.h.
 */
export const builtins = module('builtins', { ...functions, ...types, ...exceptions });
