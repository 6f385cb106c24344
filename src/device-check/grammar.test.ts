import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { play } from '#vm/library/testing/play';
import { checkForDevice } from './check-for-device';

/**
 * Short programs that MicroPython's grammar and the built-in functions accept. Source: py/grammar.h, py/lexer.c,
 * py/compile.c, py/obj*.c with the switches of the level CORE_FEATURES (py/mpconfig.h) and of the board's
 * mpconfigport.h, v1.18 and v1.23.
 */
const EVERY_BOARD = [
  ...['(n := 3)', '1_000', '0o17', '0777', 'hour = 08', 'rb"a" + br"b"', '"a" "b"', '2j', '...', '__debug__'],
  ...['"\\u00e4" == "ä"', 'größe = 1', 'x = 1; y = 2', 'x = \\\n  1', '"""a\nb"""', 'if 1: pass', '-2 ** 2', '~1'],
  ...['x: int = 3', 'def f(a: int) -> int:\n    return a', 'def f(a, b=1, *c, d, e=2, **g):\n    pass'],
  ...['def f(*, a):\n    pass', 'f = lambda *a, **k: (yield)', '@callable\nclass A(tuple):\n    pass'],
  ...['a = b = 1', 'a, *b = 1, 2, 3', 'a = 1\ndel (a,)', '1 if 2 else 3', '1 < 2 < 3'],
  ...['async def f():\n    await g()', 'async def f():\n    async for x in g():\n        pass'],
  ...['async def f():\n    async with g() as x:\n        pass', 'def f():\n    yield from [1]'],
  ...['def f():\n    a = 1\n    def g():\n        nonlocal a\n        a = 2\n    g()\nf()', 'global x', 'assert 1'],
  ...['while False:\n    pass\nelse:\n    pass', 'for i in []:\n    pass\nelse:\n    pass'],
  ...['try:\n    pass\nexcept:\n    pass\nelse:\n    pass\nfinally:\n    pass', 'from sys import (path, version)'],
  ...['try:\n    raise ValueError from None\nexcept (OSError, ValueError) as e:\n    pass', 'import os as o'],
  ...['with open("a", "w") as a, open("b", "w") as b:\n    pass', '{1, 2}', '{x for x in [1]}', '{x: 1 for x in [1]}'],
  ...['[(x, y) for x, y in [(1, 2)] if x for z in [2]]', 'l = [1, 2]\nl[0:1] = [4]\ndel l[0:1]', 'bytearray(2)[0:1]'],
  ...['print(*[1, 2])', 'dict(**{"a": 1})', '"%(a)s %5.2f %r" % {"a": 1} if 0 else "%5.2f %r" % (1, 2)'],
  ...['"{0} {b!r:>5} {1:,}".format(1, 1000, b=2)', '"{:>{}}".format(1, 5)', '"{:%} {:e} {:n}".format(0.5, 1.5, 1)'],
  ...['int("1_000")', 'int("0x1F")', 'int(b"3")', 'float("inf")', 'complex("2j")', 'str(b"a", "utf-8")'],
  ...['min([], default=1)', 'max(1, 2, key=abs)', 'sum([1], 2)', 'enumerate([1], 2)', 'sorted([1], reverse=True)'],
  ...[
    '[1].sort(key=abs, reverse=True)',
    '[1].index(1, 0, 1)',
    '{}.pop(1, 2)',
    '"abc".rsplit("b", 1)',
    'round(1.25, 1)',
  ],
  ...[
    'exec("1", {})',
    'eval("1", {}, {})',
    'type("A", (), {})',
    'isinstance(1, (int, str))',
    'reversed([1])',
    'hash(1.5)',
  ],
  ...[
    'class A(int):\n    pass\nA(3) + 1',
    'class A:\n    def __iadd__(self, o):\n        return self\na = A()\na += 1',
  ],
  ...['class A:\n    def __getattr__(self, n):\n        return 1\nA().x', 'class A:\n    pass\nA().__dict__'],
  ...['"abc".startswith("b", 1)', '"abc".endswith("c")', 'import struct\nstruct.pack("<hB3s", 1, 2, b"a")'],
  ...['text = "a"\ntext += "b"\nrow = []\nrow += [1]\nn = 2\nn **= 3', '{1} | {2}', 's = {1}\ns |= {2}'],
  ...['(300).to_bytes(2, "big")', 'int.from_bytes(b"ab", "little")', 'import math\nmath.log(8, 2)', 'pow(2, 3)'],
];

/** Programs by the version that first accepts them: the number after "1." */
const SINCE: readonly (readonly [minor: number, program: string])[] = [
  [19, 'print(*[1], *[2])'],
  [19, 'print(*[1], 2)'],
  [19, 'text = "a"\ntext *= 2'],
  [19, 'row = [0]\nrow *= 9'],
  [19, 'from microbit import *\npic = Image("1:")\npic += Image("2:")'],
  [20, '{1: 2} | {3: 4}'],
  [20, 'bytearray(b"a,b").split(b",")'],
  [20, 'bytearray(b"a").startswith(b"a")'],
  [23, 'import struct\nstruct.calcsize("Bx")'],
  [23, 'complex("1+2j")'],
  [24, '(5).to_bytes(2)'],
  [24, 'int.from_bytes(b"ab")'],
];

/** Programs that no board accepts. */
const NO_BOARD = [
  ...['x = 1\nf"{x}"', 'x = 1\nf"{x=}"', 'F"a"', 't"a"', 'print 1', '1L', 'ur"a"', '`1`', '1 <> 2', 'exec "a"'],
  ...['def f(a, /, b):\n    pass', '{**{1: 2}}', '[*[1], 2]', 'def f():\n    return *[1], 2\nf()', '"a" b"b"'],
  ...['for x in *[1], 2:\n    pass', '"\\N{DEGREE SIGN}"', 'try:\n    pass\nexcept* ValueError:\n    pass'],
  ...[
    'l = [callable]\n@l[0]\nclass A:\n    pass',
    'match 3:\n    case 3:\n        pass',
    'class A(metaclass=type):\n    pass',
    'l = [1, 2]\nl[::2] = [4]',
  ],
  ...[
    'async def f():\n    return [x async for x in g()]',
    'print(1, file=None)',
    'print(1, flush=True)',
    'slice(1, 2)',
  ],
  ...['"a b".split(sep=" ")', '"a,b".split(",", maxsplit=1)', 'def f():\n    pass\nf.x = 3', '"{[0]}".format([1])'],
  ...['def f():\n    pass\nf.__name__', 'def f():\n    pass\nf.__code__', 'class A:\n    pass\nA().__class__.__mro__'],
  ...['"abc".startswith("b", 1, 2)', '"abc".endswith("b", 0, 2)', '"abc".endswith(("a", "c"))', '"a".center(3)'],
  ...[
    '"a\\nb".splitlines()',
    '"a,b".partition(",")',
    'b"a".hex()',
    'bytes.fromhex("aa")',
    '"a".title()',
    '"a".zfill(3)',
  ],
  ...[
    'b = bytearray(2)\nb[0:1] = b"ab"',
    'b = bytearray(2)\ndel b[0]',
    'pow(2, 5, 7)',
    'round(5, 1)',
    'next(iter([]), 1)',
  ],
  ...['NotImplemented', 'compile("1", "a", "eval")', '(-1).to_bytes(2, "big", signed=True)', '(1).bit_length()'],
  ...[
    'class A:\n    def __mul__(self, o):\n        return 1\nA() * 2',
    'class A:\n    def __radd__(self, o):\n        return 1\n1 + A()',
  ],
  ...[
    'class A:\n    def __abs__(self):\n        return 1\nabs(A())',
    'class A:\n    def __index__(self):\n        return 1\n[1, 2][A()]',
  ],
  ...['class A:\n    def __setattr__(self, n, v):\n        pass\nA().x = 1', 'object.__setattr__'],
  ...['class A:\n    def __imul__(self, o):\n        return self\na = A()\na *= 1', 'open("main.py").seek(0)'],
  ...['for line in open("main.py"):\n    pass', 'from microbit import *\nsum(audio.AudioFrame())', '"%a" % 1'],
  ...['from collections import deque\ndeque((), 2)', 'import math\nmath.inf', 'import math\nmath.factorial(3)'],
  ...[
    'from collections import namedtuple\nnamedtuple("a", "b")(1)._asdict()',
    'import sys\nsys.exc_info()',
    'input(1, 2)',
  ],
];

/** Programs that our VM accepts, no board does, and nothing marks. */
const LEFT_ALONE: Readonly<Record<string, string>> = {
  '"{:_}".format(1000)': 'MicroPython 1.26 brought it; no course and no book for the board has it',
};

const boards = [
  { name: 'micro:bit V2', type: microbitV2, firmware: microbitV2.firmwares[0] },
  { name: 'micro:bit V2 with its newest firmware', type: microbitV2, firmware: microbitV2.firmwares.at(-1) },
  { name: 'Calliope mini 3', type: calliopeMini3, firmware: calliopeMini3.firmwares[0] },
].flatMap(({ firmware, ...rest }) => (firmware === undefined ? [] : [{ ...rest, firmware }]));

describe.each(boards)('the grammar of the $name', ({ type, firmware }) => {
  const { features, micropython } = firmware;
  const isMarked = (program: string): boolean =>
    checkForDevice({ 'main.py': program }, { features, micropython }).length > 0;
  const isTaken = (program: string): boolean => {
    const ended = play(program, {}, () => undefined, { type, firmware })
      .until(1000)
      .ended();
    return ended?.kind === 'finished' && ended.exception === null;
  };
  const taken = [...EVERY_BOARD, ...SINCE.filter(([minor]) => minor <= micropython[1]).map(([, program]) => program)];
  const refused = [...NO_BOARD, ...SINCE.filter(([minor]) => minor > micropython[1]).map(([, program]) => program)];

  it('is taken, and nothing in it is marked', () => {
    expect(taken.filter((program) => !isTaken(program))).toEqual([]);
    expect(taken.filter(isMarked)).toEqual([]);
  });

  it('is all that is taken, but for what is marked or left alone with a reason', () => {
    expect(refused.filter((program) => isTaken(program) && !isMarked(program))).toEqual([]);
    expect(Object.keys(LEFT_ALONE).filter((program) => !isTaken(program) || isMarked(program))).toEqual([]);
  });
});
