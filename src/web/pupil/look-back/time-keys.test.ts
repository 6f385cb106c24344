import { describe, expect, it } from 'vitest';
import { keyStep } from './time-keys';

describe('the keys of the time line', () => {
  it.each([
    ['ArrowLeft', 980_000],
    ['ArrowRight', 1_020_000],
    ['PageUp', 2_000_000],
    ['PageDown', 0],
    ['Home', 0],
    ['End', 9_000_000],
    ['a', null],
  ])('%s leads from 1 s to %s µs', (key, to) => expect(keyStep(key, 1_000_000, 9_000_000)).toBe(to));
});
