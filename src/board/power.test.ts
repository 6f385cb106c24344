import { describe, expect, it } from 'vitest';
import { createBench } from './testing/bench';

const NINES = Uint8Array.from({ length: 25 }, () => 9);

describe('power', () => {
  it('E1: while the board sleeps its LEDs are dark; awake they show what they showed', () => {
    const { board, picture } = createBench();
    board.display.show(NINES);
    board.power.sleep([]);
    expect([board.power.state, picture()]).toEqual(['asleep', '.....\n.....\n.....\n.....\n.....']);
    board.power.wake();
    expect([board.power.state, picture().startsWith('99999')]).toEqual(['on', true]);
  });

  it('E2: a board that is off does not wake up; a reset switches it on', () => {
    const { power } = createBench().board;
    power.off();
    power.wake();
    expect(power.state).toBe('off');
    power.reset();
    expect(power.state).toBe('on');
  });

  it('E3: wakes when one of its sources wants it', () => {
    const { power } = createBench().board;
    let wanted = false;
    const isOver = power.sleep([{ arm: () => () => false }, { arm: () => () => wanted }]);
    expect(isOver()).toBe(false);
    wanted = true;
    expect(isOver()).toBe(true);
  });
});
