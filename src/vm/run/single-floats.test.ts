import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { formatSingle, parseSingle } from './single-float-text';
import { linesOf } from '../library/testing/play';

/**
 * Expressions and what the board prints for them. Made with the C of MicroPython v1.18 that reads and writes numbers,
 * compiled with single floats; this project's VM had no part in it.
 */
const table = readFileSync(new URL('testing/single-floats.tsv', import.meta.url), 'utf8')
  .trim()
  .split('\n')
  .map((line) => line.split('\t') as [expression: string, printed: string]);

/** As many expressions as fit into the board's memory at once. */
const AT_ONCE = 280;

const printed = (expressions: readonly string[]): readonly string[] =>
  linesOf(`import math\n${expressions.map((expression) => `print(${expression})`).join('\n')}`);

describe('decimal numbers', () => {
  it.each(Array.from({ length: Math.ceil(table.length / AT_ONCE) }, (_, part) => part))(
    'are what the board prints, in more than a thousand expressions (part %i)',
    (part) => {
      const rows = table.slice(part * AT_ONCE, (part + 1) * AT_ONCE);
      const here = printed(rows.map(([expression]) => expression));
      expect(rows.map(([expression], index) => [expression, here[index]])).toEqual(rows);
    },
  );

  it('are the board’s on the first thermometer', () => {
    expect(printed(['21 * 1.8 + 32', '0.1 + 0.2', '1 / 3'])).toEqual(['69.8', '0.3', '0.3333333']);
  });

  it('are drawn as on the board', () => {
    expect(linesOf('import random\nrandom.seed(1)\nprint(random.random(), random.uniform(1, 2))')).toEqual([
      '0.2386861 1.069395',
    ]);
  });

  it('are singles in memory too: in lists, arrays, bytes and constants', () => {
    const program = `
import array, struct, math
print(array.array('d', [0.1])[0] == 0.1, struct.unpack('<d', struct.pack('<d', 0.1))[0] == 0.1)
print(struct.unpack('<d', struct.pack('<d', 0.1)) == struct.unpack('<f', struct.pack('<f', 0.1)))
print(math.pi == struct.unpack('<f', struct.pack('<f', math.pi))[0], math.degrees(math.pi))`;
    expect(linesOf(program)).toEqual(['True True', 'True', 'True 180.0']);
  });

  it('end at 3.4e38, beyond which they are infinite', () => {
    expect(printed(['3.4e38 * 10', '-1e39', 'float("1e39")', 'int(3e38) > 10 ** 38'])).toEqual([
      ...['inf', '-inf', 'inf', 'True'],
    ]);
    expect(linesOf('import math\nerr(math.exp, 100)')).toEqual(['ValueError: math domain error']);
  });

  it('do not tell whole numbers above 2²⁴ apart', () => {
    expect(printed(['16777217 == 16777216.0', '16777217 + 0.0', '123456789 / 1'])).toEqual([
      ...['True', '1.677722e+07', '1.234568e+08'],
    ]);
  });
});

describe('the text of a number', () => {
  const code = (letter: string): number => letter.charCodeAt(0);

  it('has a capital exponent for a capital letter, and a sign where one is asked for', () => {
    expect(formatSingle(12345, code('E'), 2, code('+'))).toBe('+1.23E+04');
    expect(formatSingle(-Infinity, code('F'), 2, 0)).toBe('-INF');
    expect(formatSingle(NaN, code('f'), 2, code(' '))).toBe(' nan');
  });

  it('is read as the nearest single where it has few digits', () => {
    for (const text of ['0.1', '3.141593', '1e-45', '123456789', '1_000.5', '.5', '5.'])
      expect(parseSingle(text)).toBe(Math.fround(Number(text.replace('_', ''))));
  });

  it('may be read as the single beside it where it has many, as on the board', () => {
    expect(parseSingle('3.14159274')).not.toBe(Math.fround(Math.PI));
    expect(parseSingle('3.14159274')).toBeCloseTo(Math.PI, 6);
  });
});
