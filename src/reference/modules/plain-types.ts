import { fn, type } from '../table';
import type { Names } from '../types';

/** Numbers, texts and bytes. Source: micropython v1.18, py/obj*.c at the level of the micro:bit's firmware. */
export const intType = type(['(x=0)', '(text: str, base: int = 10)'], {
  to_bytes: fn('(length: int, byteorder: str) -> bytes'),
  from_bytes: fn('(data: bytes, byteorder: str) -> int'),
});
export const floatType = type(['(x=0.0)'], {});
export const boolType = type(['(x=False)'], {}, 'int');

const textNames = (text: 'str' | 'bytes'): Names => ({
  split: fn(`(sep: ${text} | None = None, maxsplit: int = -1) -> list[${text}]`),
  rsplit: fn(`(sep: ${text} | None = None, maxsplit: int = -1) -> list[${text}]`),
  join: fn(`(parts: list[${text}]) -> ${text}`),
  strip: fn(`(chars: ${text} = ...) -> ${text}`),
  lstrip: fn(`(chars: ${text} = ...) -> ${text}`),
  rstrip: fn(`(chars: ${text} = ...) -> ${text}`),
  replace: fn(`(old: ${text}, new: ${text}, count: int = -1) -> ${text}`),
  find: fn(`(sub: ${text}, start: int = 0, end: int = ...) -> int`),
  rfind: fn(`(sub: ${text}, start: int = 0, end: int = ...) -> int`),
  index: fn(`(sub: ${text}, start: int = 0, end: int = ...) -> int`),
  rindex: fn(`(sub: ${text}, start: int = 0, end: int = ...) -> int`),
  count: fn(`(sub: ${text}, start: int = 0, end: int = ...) -> int`),
  startswith: fn(`(prefix: ${text}) -> bool`),
  endswith: fn(`(suffix: ${text}) -> bool`),
  upper: fn(`() -> ${text}`),
  lower: fn(`() -> ${text}`),
  isalpha: fn('() -> bool'),
  isdigit: fn('() -> bool'),
  isspace: fn('() -> bool'),
  isupper: fn('() -> bool'),
  islower: fn('() -> bool'),
});

export const strType = type(["(x='')"], {
  format: fn('(*values, **named) -> str'),
  ...textNames('str'),
  encode: fn('() -> bytes'),
});

const spokenByStr = (names: Names): Names =>
  Object.fromEntries(Object.entries(names).map(([name, it]) => [name, { ...it, text: `builtins.str.${name}` }]));

export const bytesType = type(['(x=0)', '(text: str, encoding: str)'], {
  ...spokenByStr(textNames('bytes')),
  decode: fn('() -> str'),
});
export const bytearrayType = type(['(x=0)', '(text: str, encoding: str)'], {
  append: fn('(value: int) -> None'),
  extend: fn('(values: bytes) -> None'),
  decode: fn('() -> str'),
});
