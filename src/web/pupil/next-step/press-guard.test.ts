import { describe, expect, it } from 'vitest';

import { pressGuard } from './press-guard';

describe('the button of the next step', () => {
  it('takes a second press within a second for a part of the first', () => {
    let nowMs = 0;
    let missions = 1;
    const press = pressGuard(() => nowMs);
    const next = (): void => void (missions += 1);
    press(next);
    nowMs = 999;
    press(next);
    expect(missions).toBe(2);
    nowMs = 1000;
    press(next);
    expect(missions).toBe(3);
  });
});
