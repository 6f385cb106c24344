import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { formatSingle, parseSingle } from './single-float-text';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { linesOf, type Device } from '../library/testing/play';

/**
 * Expressions and what the board prints for them. Made with the C of MicroPython that reads and writes numbers,
 * compiled with single floats; this project's VM had no part in it.
 */
const tableOf = (file: string): [expression: string, printed: string][] =>
  readFileSync(new URL(`testing/${file}`, import.meta.url), 'utf8')
    .trim()
    .split('\n')
    .map((line) => line.split('\t') as [string, string]);

const table = tableOf('single-floats.tsv'); // v1.18
const newerTable = tableOf('single-floats-newer.tsv'); // v1.23

/** As many expressions as fit into the board's memory at once. */
const AT_ONCE = 280;

const printed = (expressions: readonly string[], device: Device = {}): readonly string[] =>
  linesOf(
    `import math\n${expressions.map((expression) => `print(${expression})`).join('\n')}`,
    {},
    () => undefined,
    device,
  );

const newest = microbitV2.firmwares.find(({ id }) => id === 'newest');

describe('decimal numbers', () => {
  it.each(Array.from({ length: Math.ceil(table.length / AT_ONCE) }, (_, part) => part))(
    'are what the board prints, in more than a thousand expressions (part %i)',
    (part) => {
      const rows = table.slice(part * AT_ONCE, (part + 1) * AT_ONCE);
      const here = printed(rows.map(([expression]) => expression));
      expect(rows.map(([expression], index) => [expression, here[index]])).toEqual(rows);
    },
  );

  it.each<[string, Device]>([
    ['Calliope mini 3', { type: calliopeMini3 }],
    ['micro:bit with the newest firmware', { firmware: newest }],
  ])('are what MicroPython 1.23 prints on the %s', (_, device) => {
    for (let at = 0; at < newerTable.length; at += AT_ONCE) {
      const rows = newerTable.slice(at, at + AT_ONCE);
      const here = printed(
        rows.map(([expression]) => expression),
        device,
      );
      expect(rows.map(([expression], index) => [expression, here[index]])).toEqual(rows);
    }
  });

  it('are the board’s on the first thermometer', () => {
    expect(printed(['21 * 1.8 + 32', '0.1 + 0.2', '1 / 3'])).toEqual(['69.8', '0.3', '0.3333333']);
  });

  it('are drawn as on the board', () => {
    expect(linesOf('import random\nrandom.seed(1)\nprint(random.random(), random.uniform(1, 2))')).toEqual([
      '0.2386861 1.069395',
    ]);
  });

  it('are single where they become complex: the root of a negative number is beside the axis', () => {
    expect(printed(['(-4.0) ** 0.5', '(-2.0) ** 1.5', '(1+2j) ** (0.5+1j)', '(0.1+0.2j) * (3+0.1j)'])[0]).toBe(
      '(-8.742278e-08+2j)',
    );
  });

  it('have the place of their whole part in a set', () => {
    // Beyond 31 bits that is the largest one: the board's processor converts so (a PC's gives the smallest).
    const dictionary = '{1.5: 1, 2811.6: 2, 1e10: 3, 20.166: 4, -7.25: 5, 0.1: 6}';
    expect(printed(['{0.5, 12.75, 3.25, -1.1, 99.9}', '{0.1 * i for i in range(6)}', dictionary])).toEqual([
      '{0.5, -1.1, 12.75, 3.25, 99.90001}',
      '{0.0, 0.1, 0.2, 0.3, 0.4, 0.5}',
      '{0.1: 6, 1.5: 1, 20.166: 4, 2811.6: 2, 1e+10: 3, -7.25: 5}',
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

describe('everyday decimals: tenths up to 200, hundredths up to 10', () => {
  const written = [
    ...Array.from({ length: 2000 }, (_, n) => ((n + 1) / 10).toFixed(1)),
    ...Array.from({ length: 1000 }, (_, n) => ((n + 1) / 100).toFixed(2)),
  ];
  const repr = (minor: number, text: string): string =>
    formatSingle(minor, parseSingle(minor, text), 'g'.charCodeAt(0), 99, 0);
  const others = (minor: number): string[] =>
    written.filter((text) => repr(minor, text) !== String(Number(text))).map((text) => `${text} ${repr(minor, text)}`);

  it('are printed as they are written by 1.23, except two', () =>
    expect(others(23)).toEqual(['0.96 0.9599999', '0.97 0.9700001']));

  it('have one too many in the last place in 46 more cases by 1.18', () => {
    expect(others(18)).toHaveLength(48);
    expect(others(18).slice(0, 3)).toEqual(['66.3 66.30001', '68.8 68.80001', '71.3 71.30001']);
  });
});

describe('zeros at the end of a decimal', () => {
  it('make two numbers of one in 1.18', () => {
    const program = 'print(1022083.00 == 1022083, 54.2700000, 483727235.00, 4.300e25, 2.50, 0.10)';
    expect(linesOf(program)).toEqual(['False 54.27001 4.837273e+08 4.3e+25 2.5 0.1']);
    expect(linesOf(program, {}, () => undefined, { type: calliopeMini3 })[0]).toMatch(/^True 54.27 /);
  });
});

describe('the text of a number', () => {
  const code = (letter: string): number => letter.charCodeAt(0);

  it('has a capital exponent for a capital letter, and a sign where one is asked for', () => {
    expect(formatSingle(18, 12345, code('E'), 2, code('+'))).toBe('+1.23E+04');
    expect(formatSingle(18, -Infinity, code('F'), 2, 0)).toBe('-INF');
    expect(formatSingle(18, NaN, code('f'), 2, code(' '))).toBe(' nan');
  });

  it('is read as the nearest single where it has few digits', () => {
    for (const text of ['0.1', '3.141593', '1e-45', '123456789', '1_000.5', '.5', '5.'])
      expect([18, 23].map((minor) => parseSingle(minor, text))).toEqual(
        Array(2).fill(Math.fround(Number(text.replace('_', '')))),
      );
  });

  it('may be read as the single beside it where it has many, as on the board', () => {
    expect(parseSingle(18, '3.14159274')).not.toBe(Math.fround(Math.PI));
    expect(parseSingle(18, '3.14159274')).toBeCloseTo(Math.PI, 6);
  });
});
