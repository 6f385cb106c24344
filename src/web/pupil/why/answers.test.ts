import { describe, expect, it } from 'vitest';

import type { Cause } from '#simulation/causes/causes';
import type { Output } from '#simulation/causes/output';
import { filled } from '../../kit/i18n/filled';
import { allAnswers, outputAnswer, placesOf, printedAnswer, robotAnswer, type Answer } from './answers';

const cause = (output: Output, value: Cause['value'], line = 3, sinceUs = 1_000_000): Cause => ({
  ...{ output, value, sinceUs, again: null },
  lines: [{ file: 'main.py', line }],
});
const told = ({ name, nameValues, since, sinceValues, cause: of, missing }: Answer): string => {
  const state = filled((since ?? missing)?.en ?? '', { ...sinceValues, time: '1.0' }, 'en');
  return `${filled(name.en, nameValues, 'en')}: ${state} (${of?.lines[0]?.line ?? '–'})`;
};

describe('the answer to why', () => {
  it('names for a robot that stands the line that stopped its last wheel', () => {
    const causes = [cause('wheel-left', 0, 4, 2_000_000), cause('wheel-right', 0, 5, 3_000_000)];
    expect(told(robotAnswer(causes))).toBe('Robot: Stands since 1.0 s (5)');
  });

  it('names for one that drives the line by which it began to drive like this', () => {
    const causes = [cause('wheel-left', 0.4, 4, 2_000_000), cause('wheel-right', 0, 5, 1_000_000)];
    expect(told(robotAnswer(causes))).toMatch(/^Robot: Drives like this since .* \(4\)$/);
  });

  it('says that no line has controlled the motor, where none has', () => {
    expect(told(robotAnswer([]))).toBe('Robot: No line has controlled the motor yet. (–)');
    expect(told(outputAnswer([], 'wheel-left'))).toMatch(/^Left wheel: No line has controlled the motor yet/);
    expect(told(outputAnswer([], 'light-left'))).toMatch(/^Left light: No line has controlled this yet/);
    expect(allAnswers([cause('display', '9')], true).map(({ key }) => key)).toEqual(['robot', 'display']);
    expect(allAnswers([], false)).toEqual([]);
  });

  it('takes both wheels, both lights and all colours together while one line has made them so', () => {
    const causes = [
      cause('wheel-left', -0.4),
      cause('wheel-right', 0.4),
      cause('light-left', 1, 5),
      cause('light-right', 0, 6),
      ...[0, 1, 2].map((place) => cause(`color-${place}`, '0,0,0', 8, 1_000_000 + 3000 * place)),
    ];
    expect(allAnswers(causes, true).map(told)).toEqual([
      expect.stringMatching(/^Wheels: Drives like this .* \(3\)$/),
      expect.stringMatching(/^Left light: Shines since .* \(5\)$/),
      expect.stringMatching(/^Right light: Off since .* \(6\)$/),
      expect.stringMatching(/^Colour lights: Off since .* \(8\)$/),
    ]);
  });

  it.each([
    [cause('wheel-left', -0.4), /^Left wheel: Backwards/],
    [cause('wheel-right', 'line 1'), /^Right wheel: Drives like this/],
    [cause('servo-S1', 90), /^Servo S1: At 90° since 1.0 s/],
    [cause('display', '0'.repeat(25)), /^Display: Dark/],
    [cause('display', null), /^Display: Shows this/],
    [cause('sound', 'off'), /^Sound: Silent/],
    [cause('sound', null), /^Sound: Began/],
    [cause('pin-P16', '0'), /^Pin P16: Off/],
    [cause('pin-P16', '0.5 of 20000'), /^Pin P16: Like this/],
    [cause('chain-P2', '9,0,0,0,0,0'), /^Light chain at P2: Shines/],
    [cause('color-0', '10,0,0'), /^Colour light 1: Shines/],
    [cause('motor-1', 0), /^Motor 1: Stands/],
    [cause('radio', null), /^Radio: Sent/],
  ])('says what %o is like', (one, expected) => expect(told(outputAnswer([one], one.output))).toMatch(expected));

  it('says of a line in the console that no line of the program has printed it', () => {
    expect(told(printedAnswer([]))).toMatch(/^Console: This did not come from a line of your program/);
    expect(told(printedAnswer([cause('console', null, 7)]))).toMatch(/^Console: Written at .* \(7\)/);
  });

  it('goes to the innermost line, and tells who in another file has called it', () => {
    const lines = [
      { file: 'far.py', line: 5 },
      { file: 'far.py', line: 3 },
      { file: 'main.py', line: 4 },
    ];
    expect(placesOf(lines)).toEqual({ at: lines[0], from: lines[2] });
    expect(placesOf([lines[2]!])).toEqual({ at: lines[2], from: null });
    expect(placesOf([])).toEqual({ at: null, from: null });
  });
});
