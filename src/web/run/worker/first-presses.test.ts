import { describe, expect, it } from 'vitest';

import type { InputAction } from '#simulation/input';

import { createFirstPresses } from './first-presses';

const a = (down: boolean): InputAction => ({ type: 'button', button: 'a', down });
const b = (down: boolean): InputAction => ({ type: 'button', button: 'b', down });

describe('what is pressed before a program begins', () => {
  it('is pressed at its first moment and let go 60 ms later', () => {
    const timeOf = createFirstPresses();
    expect([a(true), a(false), a(true), b(true)].map((action) => timeOf(action, 0))).toEqual([0, 60_000, 120_000, 0]);
  });

  it('leaves everything else where it is', () => {
    const timeOf = createFirstPresses();
    const text: InputAction = { type: 'serial', text: 'x' };
    expect([a(true), text, text].map((action) => timeOf(action, 0))).toEqual([0, 0, 0]);
  });

  it('comes before what is pressed soon after, which keeps its distance', () => {
    const timeOf = createFirstPresses();
    expect([timeOf(a(true), 0), timeOf(a(false), 0), timeOf(a(true), 8000)]).toEqual([0, 60_000, 120_000]);
  });

  it('changes nothing about a finger that presses while the program runs', () => {
    const timeOf = createFirstPresses();
    timeOf(a(true), 0);
    expect([timeOf(a(false), 500_000), timeOf(a(true), 501_000), timeOf(a(false), 502_000)]).toEqual([
      500_000, 501_000, 502_000,
    ]);
  });
});
