import { describe, expect, it } from 'vitest';
import type { Change } from './change';
import { numberToTry } from './number-to-try';

const PROGRAM = 'forward()\ndelay(650)\nmotor(0, 100)\n';
const turning = (line: number, before: string, after: string): Change => ({
  ...{ kind: 'number', line, before: [before], after: [after], direction: 'more' },
});

describe('the number that a hint turns', () => {
  it('has the name of a sweep: its line, and its place among several', () => {
    expect(numberToTry(turning(2, 'delay(650)', 'delay(760)'), PROGRAM)).toBe('main.py:2');
    expect(numberToTry(turning(3, 'motor(0, 100)', 'motor(0, 80)'), PROGRAM)).toBe('main.py:3.2');
  });

  it('is none of another kind of change', () =>
    expect(numberToTry({ ...turning(2, 'delay(650)', 'stop()'), kind: 'name', direction: null }, PROGRAM)).toBeNull());
});
