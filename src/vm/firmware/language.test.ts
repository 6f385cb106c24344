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
err(change, 'a |= {1}', {1})`;

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

describe('an endless loop of short calls', () => {
  it.each(['("ab" * 9000).count("ba")', 'hash("x" * 20000)', 'int("7" * 3000)', '[0] * 3000 == [0] * 3000'])(
    'uses up simulated time: %s',
    (call) => {
      const program = `import time\nt = time.ticks_us()\nfor i in range(10):\n    ${call}\nprint(time.ticks_us() - t)`;
      expect(Number(play(program).until(10_000).printed())).toBeGreaterThan(10_000);
    },
  );
});
