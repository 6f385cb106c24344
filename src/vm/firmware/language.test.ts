import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { linesOf, play } from '../library/testing/play';

const onCalliope = (program: string): string[] => linesOf(program, {}, () => undefined, { type: calliopeMini3 });

describe('whole numbers of the board’s MicroPython', () => {
  it('may begin with zeros, and are decimal', () => {
    const program = 'hour = 08\nminute = 017\nprint(hour, minute, -09, 00, 0x1F, int("007"))';
    expect(linesOf(program)).toEqual(['8 17 -9 0 31 7']);
  });

  it('are read from texts that say their base', () => {
    const program = 'print([int(t) for t in ("0x1F", "0b101", "0o17", "-0x10", " 0xff ", "12")])\nerr(int, "0x")';
    const printed = ['[31, 5, 15, -16, 255, 12]', 'ValueError: invalid syntax for integer with base 16'];
    expect(linesOf(program)).toEqual(printed);
    expect(onCalliope(program)).toEqual(printed);
  });
});

describe('operators of whole numbers', () => {
  const most = 2n ** 30n - 1n; // of a small int
  const numbers = [0n, 1n, -1n, 7n, -13n, 46341n, most, -most, -most - 1n, most + 1n];
  const shifts = [0n, 1n, 29n, 30n, 31n, 32n, 40n];
  const asPython = (values: readonly (bigint | boolean)[]) =>
    values.map((value) => (typeof value === 'bigint' ? String(value) : value ? 'True' : 'False')).join(' ');
  const pairs = numbers.flatMap((a) => numbers.map((b) => [a, b] as const));
  const printed = (expression: string, given: string) =>
    `print(*[${expression} for ${given}])`.replaceAll('NUMBERS', `(${numbers.join(', ')})`);

  it.each<[string, (a: bigint, b: bigint) => bigint | boolean]>([
    ['+', (a, b) => a + b],
    ['-', (a, b) => a - b],
    ['*', (a, b) => a * b],
    ['&', (a, b) => a & b],
    ['|', (a, b) => a | b],
    ['<', (a, b) => a < b],
    ['>', (a, b) => a > b],
    ['<=', (a, b) => a <= b],
    ['>=', (a, b) => a >= b],
    ['==', (a, b) => a === b],
    ['!=', (a, b) => a !== b],
  ])('are those of Python where a small int ends, too: a %s b', (operator, result) => {
    const program = printed(`a ${operator} b`, 'a in NUMBERS for b in NUMBERS');
    expect(linesOf(program)).toEqual([asPython(pairs.map(([a, b]) => result(a, b)))]);
  });

  it('shift and turn signs as Python does', () => {
    const program = [
      printed('a >> b', `a in NUMBERS for b in (${shifts.join(', ')})`),
      printed('-a', 'a in NUMBERS'),
      printed('+a', 'a in NUMBERS'),
      printed('~a', 'a in NUMBERS'),
      printed('not a', 'a in NUMBERS'),
      'print(*[-a for a in (True, False)], *[~a for a in (True, False)], 5 > True, None is None, 5 is 5, "a" is 5)',
      'err(lambda: 1 >> -1)',
    ].join('\n');
    expect(linesOf(program)).toEqual([
      asPython(numbers.flatMap((a) => shifts.map((b) => a >> b))),
      asPython(numbers.map((a) => -a)),
      asPython(numbers),
      asPython(numbers.map((a) => ~a)),
      asPython(numbers.map((a) => a === 0n)),
      '-1 0 -2 -1 True True True False',
      'ValueError: negative shift count',
    ]);
  });
});

describe('bytes of a whole number', () => {
  it('are cut where they do not fit, and 0 beyond the number’s own, on every board', () => {
    const program = `
print((300).to_bytes(1, "little"), (-300).to_bytes(1, "little"), (-1).to_bytes(2, "big"))
print((-1).to_bytes(8, "little"), (1000).to_bytes(6, "big"))
print((10 ** 20).to_bytes(6, "big"), (-(10 ** 12)).to_bytes(8, "little"))`;
    const printed = [
      "b',' b'\\xd4' b'\\xff\\xff'",
      "b'\\xff\\xff\\xff\\xff\\x00\\x00\\x00\\x00' b'\\x00\\x00\\x00\\x00\\x03\\xe8'",
      "b'^-c\\x10\\x00\\x00' b'\\x00\\xf0Z+\\x17\\xff\\x00\\x00'",
    ];
    expect(linesOf(program)).toEqual(printed);
    expect(onCalliope(program)).toEqual(printed);
  });
});

describe('what MicroPython 1.23 has and 1.18 lacks', () => {
  const program = `
import struct
names = ("append", "extend", "decode", "find", "split", "startswith", "upper")
print([name for name in names if hasattr(bytearray(1), name)])
err(struct.calcsize, "3xB")
err(struct.pack, "Bx", 1)
err(complex, "1+2j")
err(complex, "2j")
err(bytes, "abc")
err(bytearray, "äb")`;

  it('is refused by 1.18', () => {
    expect(linesOf(program)).toEqual([
      "['append', 'extend', 'decode']",
      ...['ValueError: bad typecode', 'ValueError: bad typecode', 'ValueError: invalid syntax for number'],
      ...['no error: 2j', 'TypeError: wrong number of arguments', "no error: bytearray(b'\\xc3\\xa4b')"],
    ]);
  });

  it('is there on the Calliope mini 3', () => {
    expect(onCalliope(program)).toEqual([
      "['append', 'extend', 'decode', 'find', 'split', 'startswith', 'upper']",
      ...['no error: 4', "no error: b'\\x01\\x00'", 'no error: (1+2j)', 'no error: 2j'],
      ...['TypeError: string argument without an encoding', 'TypeError: string argument without an encoding'],
    ]);
  });
});

describe('the line of a syntax error', () => {
  const lineOf = (program: string): string =>
    `try:
    exec(${JSON.stringify(program)})
except SyntaxError as e:
    import sys
    sys.print_exception(e)`;
  const told = (program: string): (string | undefined)[] =>
    [linesOf(lineOf(program)), onCalliope(lineOf(program))].map((lines) =>
      lines.find((it) => it.includes('<string>'))?.trim(),
    );

  it.each([
    ['n = 0\nwhile n < 3\n\n# a comment\n    n += 1\n', 5, 2],
    ['x = 3 +\nprint(x)', 2, 1],
    ['if True:\n        x = 1\n    y = 2\n', 3, 2],
    ['x = 1\nprint(1 2)\n', 2, 2],
    ['x = (1 +\n2\n)) + 3\n', 3, 3],
  ])('is the next one with code by 1.18 where a line ends too early: %j', (program, older, newer) => {
    expect(told(program)).toEqual([older, newer].map((line) => `File "<string>", line ${line}`));
  });
});

describe('operators in place', () => {
  const program = `
def change(text, value):
    names = {'a': value}
    exec(text, names)
    return names['a']
err(change, 'a *= 2', 'ab')
err(change, 'a *= 2', [0])
err(change, 'a *= 2', b'x')
err(change, 'a %= 5', '%d')
err(change, 'a *= 2', (1,))
err(change, 'a *= 2', 1.5)
err(change, 'a += "y"', 'x')
err(change, 'a |= {1}', {1})
from microbit import Image
err(change, 'a += a', Image("1:"))
err(change, 'a *= 3', Image("1:"))`;

  it('work for numbers, sets, tuples and += alone by 1.18', () => {
    expect(linesOf(program)).toEqual([
      "TypeError: unsupported types for : 'str', 'int'",
      "TypeError: unsupported types for : 'list', 'int'",
      "TypeError: unsupported types for : 'bytes', 'int'",
      "TypeError: unsupported types for : 'str', 'int'",
      'no error: (1, 1)',
      'no error: 3.0',
      'no error: xy',
      'no error: {1}',
      "TypeError: unsupported types for __iadd__: 'MicroBitImage', 'MicroBitImage'",
      "TypeError: unsupported types for : 'MicroBitImage', 'int'",
    ]);
  });

  it('work for all by 1.23', () =>
    expect(onCalliope(program).filter((line) => line.includes('TypeError'))).toEqual([]));
});

describe('a product that no memory holds', () => {
  it.each(['(0,) * (2 ** 31 - 1)', '[0] * (2 ** 30)', '("ab" * 8192) * (2 ** 18)'])(
    'is a MemoryError: %s',
    (product) => {
      expect(linesOf(`try:\n    ${product}\nexcept MemoryError:\n    print("no memory")\nprint("alive")`)).toEqual([
        'no memory',
        'alive',
      ]);
    },
  );
});

describe('names of a module', () => {
  it('come before built-in ones, which are there again without them', () => {
    const program = `
def lengths():
    return len('abc')
print(lengths())
len = lambda text: 'mine'
print(lengths())
del len
print(lengths())
class Odd:
    def __eq__(self, other): return False
    def __hash__(self): return 5
globals()[Odd()] = 1
print(lengths(), [name for name in ('lengths',) if name in globals()])
err(lambda: unheard_of)`;
    expect(linesOf(program)).toEqual(['3', 'mine', '3', "3 ['lengths']", "NameError: name 'unheard_of' isn't defined"]);
  });

  it('are looked up when the program comes to them: errno has its names alone, and none without its import', () => {
    const program = `
def without():
    return errno.EIO
err(without)
import errno
print(errno.EIO, errno.ENOSPC, len(errno.errorcode))
print(hasattr(errno, "ECONNRESET"), str(OSError(104)), OSError(28))
err(lambda: errno.ECONNRESET)`;
    const printed = [
      "NameError: name 'errno' isn't defined",
      '5 28 17',
      'False 104 [Errno 28] ENOSPC',
      "AttributeError: 'module' object has no attribute 'ECONNRESET'",
    ];
    expect(linesOf(program)).toEqual(printed);
    expect(onCalliope(program)).toEqual(printed);
  });
});

describe('gc.threshold()', () => {
  it('is -1 at first: memory is collected when it is full', () => {
    const program = `
import gc
print(gc.threshold())
lowest = gc.mem_free()
for i in range(900):
    [0] * 10
    lowest = min(lowest, gc.mem_free())
print(lowest < 2000)`;
    expect(linesOf(program)).toEqual(['-1', 'True']);
  });

  it('has each of its collections take its time', () => {
    const program =
      'import gc, time\ngc.threshold(1)\nt = time.ticks_us()\nfor i in range(20):\n    [0] * 10\nprint(time.ticks_us() - t)';
    expect(Number(play(program).until(10_000).printed())).toBeGreaterThan(20_000);
  });
});

describe('an endless loop of short calls', () => {
  it.each(['("ab" * 9000).count("ba")', 'hash("x" * 20000)', 'int("7" * 3000)', '[0] * 3000 == [0] * 3000'])(
    'uses up simulated time: %s',
    (call) => {
      const program = `import time\nt = time.ticks_us()\nfor i in range(10):\n    ${call}\nprint(time.ticks_us() - t)`;
      expect(Number(play(program).until(10_000).printed())).toBeGreaterThan(10_000);
    },
  );
});
