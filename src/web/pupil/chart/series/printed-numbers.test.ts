import { describe, expect, it } from 'vitest';
import { printedNumbers } from './printed-numbers';

const numbers = (line: string) => printedNumbers(line)?.map(({ name, value }) => [name, value]) ?? null;

describe('a printed line is taken as numbers', () => {
  it.each([
    ['23', [['', 23]]],
    ['1 2 3', [['', 1], ['', 2], ['', 3]]],
    ['(1, -2.5)', [['', 1], ['', -2.5]]],
    ['[1, 2]', [['', 1], ['', 2]]],
    ['1;2', [['', 1], ['', 2]]],
    ['1e3', [['', 1000]]],
    ['Abstand: 23', [['Abstand', 23]]],
    ['Abstand: 23 cm', [['Abstand', 23]]],
    ['Abstand 23cm', [['Abstand', 23]]],
    ['temp=21.5', [['temp', 21.5]]],
    ['links 1 rechts 0', [['links', 1], ['rechts', 0]]],
    ['links: 1, rechts: 0', [['links', 1], ['rechts', 0]]],
    ['r 1 g 2 b 3', [['r', 1], ['g', 2], ['b', 3]]],
    ['3 m', [['', 3]]],
    ['mittlerer Abstand: 7', [['mittlerer Abstand', 7]]],
    ['s: 1 m: 2', [['s', 1], ['m', 2]]],
  ])('%j', (line, found) => expect(numbers(line)).toEqual(found)); // prettier-ignore

  it.each([
    '',
    'Hallo',
    'Ich bin in Zeile 3 angekommen',
    'Zeile 3 ist da',
    '  File "main.py", line 3, in <module>',
    'MicroPython v1.27 on 2026-01-01; micro:bit v2',
    '>>> 3',
    '12:30',
    '2026-01-01',
    'nan',
    '1 2 3 4 5 6 7 8 9',
  ])('but not %j', (line) => expect(numbers(line)).toBeNull());
});
