import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { play, type Device } from '../library/testing/play';

/** Decimals that pupils meet: tenths, hundredths, degrees Celsius in Fahrenheit, parts of one. */
const families = [
  { expression: 'n / 10', first: 1, last: 2000, valueOf: (n: number) => Math.fround(n / 10) },
  { expression: 'n / 100', first: 1, last: 1000, valueOf: (n: number) => Math.fround(n / 100) },
  {
    expression: 'n * 1.8 + 32',
    first: -40,
    last: 59,
    valueOf: (n: number) => Math.fround(Math.fround(n * Math.fround(1.8)) + 32),
  },
  { expression: '1 / n', first: 1, last: 160, valueOf: (n: number) => Math.fround(1 / n) },
];

type Exceptions = Readonly<Record<string, string>>;

/**
 * Numbers for which a board does not print the nearest seven digits. Made with the C of MicroPython's
 * formatfloat.c, before and after version 1.20, compiled for single floats; this project's VM had no part in it.
 */
const before120: Exceptions = {
  'n / 10': `
    663:66.30001 688:68.80001 713:71.30001 738:73.80001 763:76.30001 788:78.80001 803:80.30001
    808:80.80001 815:81.50001 819:81.90001 824:82.40001 828:82.80001 833:83.30001 840:84.00001
    844:84.40001 849:84.90001 853:85.30001 858:85.80001 865:86.50001 869:86.90001 874:87.40001
    878:87.80001 883:88.30001 890:89.00001 894:89.40001 899:89.90001 903:90.30001 908:90.80001
    915:91.50001 919:91.90001 924:92.40001 928:92.80001 933:93.30001 940:94.00001 944:94.40001
    949:94.90001 953:95.30001 958:95.80001 965:96.50001 969:96.90001 974:97.40001 978:97.80001
    983:98.30001 990:99.00001 994:99.40001 999:99.90001`,
  'n / 100': `
    96:0.9599999 97:0.9700001`,
  'n * 1.8 + 32': `
    -36:-32.79999 18:64.4 23:73.4 26:78.80001 28:82.4 31:87.80001 36:96.79999`,
  '1 / n': `
    14:0.07142858 30:0.03333333 34:0.02941177 89:0.01123595 102:0.009803923 103:0.009708737
    107:0.009345795 113:0.008849558 116:0.008620689 118:0.008474577 126:0.007936509 134:0.007462687
    140:0.007142858 144:0.006944445 149:0.00671141 155:0.006451612`,
};
const since120: Exceptions = {
  'n / 100': `
    96:0.9599999 97:0.9700001`,
  '1 / n': `
    14:0.07142858 30:0.03333333 34:0.02941177 89:0.01123595 105:0.009523809 108:0.00925926
    109:0.009174311 113:0.008849558 115:0.008695651 118:0.008474577 119:0.008403361 121:0.008264463
    122:0.00819672 125:0.008000001 134:0.007462687 135:0.007407408 136:0.007352942 138:0.007246376
    140:0.007142858 141:0.007092199 144:0.006944445 148:0.006756758 155:0.006451612`,
};

/** Seven digits, with a point. */
const nearest = (value: number): string => String(Number(value.toPrecision(7))).replace(/^-?\d+$/, '$&.0');

const exceptionsOf = (text = ''): ReadonlyMap<number, string> =>
  new Map(
    text
      .trim()
      .split(/\s+/)
      .filter((it) => it !== '')
      .map((it) => it.split(':') as [string, string])
      .map(([n, printed]) => [Number(n), printed]),
  );

const newest = microbitV2.firmwares.find(({ id }) => id === 'newest');

describe.each<[string, Device, Exceptions]>([
  ['micro:bit V2 (MicroPython 1.18)', {}, before120],
  ['micro:bit V2 with its newest firmware', { firmware: newest }, since120],
  ['Calliope mini 3', { type: calliopeMini3 }, since120],
])('everyday decimals on the %s', (_, device, exceptions) => {
  it.each(families)('print as there: $expression', ({ expression, first, last, valueOf }) => {
    const program = `for n in range(${first}, ${last + 1}):\n    print(${expression})`;
    const printed = play(program, {}, () => undefined, device)
      .until(10_000)
      .printed()
      .trim()
      .split(/\r?\n/);
    const others = exceptionsOf(exceptions[expression]);
    const numbers = Array.from({ length: last - first + 1 }, (__, index) => first + index);
    expect(printed.map((it, index) => [numbers[index], it])).toEqual(
      numbers.map((n) => [n, others.get(n) ?? nearest(valueOf(n))]),
    );
  });
});
