import { fn, type, value } from '../table';
import type { Names } from '../types';

/** Lists, tuples, dictionaries, sets. Source: micropython v1.18, py/obj*.c at the level of the micro:bit's firmware. */
export const listType = type(['(values=[])'], {
  append: fn('(value) -> None'),
  extend: fn('(values: list) -> None'),
  insert: fn('(index: int, value) -> None'),
  pop: fn('(index: int = -1)'),
  remove: fn('(value) -> None'),
  clear: fn('() -> None'),
  copy: fn('() -> list'),
  count: fn('(value) -> int'),
  index: fn('(value, start: int = 0, end: int = ...) -> int'),
  reverse: fn('() -> None'),
  sort: fn('(*, key: function | None = None, reverse: bool = False) -> None'),
});

export const tupleType = type(['(values=())'], {
  count: fn('(value) -> int'),
  index: fn('(value, start: int = 0, end: int = ...) -> int'),
});

export const dictType = type(['(items={})', '(**named)'], {
  get: fn('(key, default=None)'),
  keys: fn('() -> list'),
  values: fn('() -> list'),
  items: fn('() -> list[tuple]'),
  pop: fn('(key, default=...)'),
  popitem: fn('() -> tuple'),
  setdefault: fn('(key, default=None)'),
  update: fn('(other: dict) -> None'),
  clear: fn('() -> None'),
  copy: fn('() -> dict'),
  fromkeys: fn('(keys: list, value=None) -> dict'),
});

const setQuestions = (own: 'set' | 'frozenset'): Names => ({
  union: fn(`(other) -> ${own}`),
  intersection: fn(`(other) -> ${own}`),
  difference: fn(`(other) -> ${own}`),
  symmetric_difference: fn(`(other) -> ${own}`),
  issubset: fn('(other) -> bool'),
  issuperset: fn('(other) -> bool'),
  isdisjoint: fn('(other) -> bool'),
  copy: fn(`() -> ${own}`),
});

export const setType = type(['(values=[])'], {
  add: fn('(value) -> None'),
  remove: fn('(value) -> None'),
  discard: fn('(value) -> None'),
  pop: fn('()'),
  clear: fn('() -> None'),
  update: fn('(values: list) -> None'),
  ...setQuestions('set'),
  difference_update: fn('(other) -> None'),
  intersection_update: fn('(other) -> None'),
  symmetric_difference_update: fn('(other) -> None'),
});

export const frozensetType = type(
  ['(values=[])'],
  Object.fromEntries(
    Object.entries(setQuestions('frozenset')).map(([name, it]) => [name, { ...it, text: `builtins.set.${name}` }]),
  ),
);

export const rangeType = type(['(stop: int)', '(start: int, stop: int, step: int = 1)'], {
  start: value('int'),
  stop: value('int'),
  step: value('int'),
});
