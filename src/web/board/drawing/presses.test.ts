import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { BOARD_KEYS, isButtonKey, Presses } from './presses';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function watched(): { presses: Presses; heard: string[] } {
  const heard: string[] = [];
  const presses = new Presses({ press: (key) => heard.push(`+${key}`), release: (key) => heard.push(`-${key}`) });
  return { presses, heard };
}

describe('the keys of the board', () => {
  it('go down with the first of two fingers and up with the last', () => {
    const { presses, heard } = watched();
    presses.hold('finger 1', ['a']);
    presses.hold('finger 2', ['a']);
    vi.advanceTimersByTime(150);
    presses.letGo('finger 1');
    expect(heard).toEqual(['+a']);
    presses.letGo('finger 2');
    expect(heard).toEqual(['+a', '-a']);
  });

  it('can be held together: 2 fingers on A and B, or 1 on A + B', () => {
    const { presses, heard } = watched();
    presses.hold('finger 1', ['a']);
    presses.hold('finger 2', ['b']);
    vi.advanceTimersByTime(100);
    presses.letGoAll();
    vi.advanceTimersByTime(100);
    presses.hold('finger 1', ['a', 'b']);
    vi.advanceTimersByTime(100);
    presses.letGo('finger 1');
    expect(heard).toEqual(['+a', '+b', '-a', '-b', '+a', '+b', '-a', '-b']);
  });

  it('stay down when the same finger is reported twice, and up when an unknown one leaves', () => {
    const { presses, heard } = watched();
    presses.hold('key', ['pinLogo']);
    presses.hold('key', ['pinLogo']);
    presses.letGo('mouse');
    expect(heard).toEqual(['+pinLogo']);
    expect(presses.isDown('pinLogo')).toBe(true);
  });

  it('are 2 buttons and 5 pads that feel a finger, visited in the order A, B, logo, pins 0 to 3', () => {
    expect(BOARD_KEYS.filter(isButtonKey)).toEqual(['a', 'b']);
    expect(BOARD_KEYS.filter((key) => !isButtonKey(key))).toEqual(['pinLogo', 'pin0', 'pin1', 'pin2', 'pin3']);
  });

  it('hold 4 touch pins with 4 fingers, each let go alone', () => {
    const { presses, heard } = watched();
    for (const pin of [0, 1, 2, 3] as const) presses.hold(`finger ${pin}`, [`pin${pin}`]);
    vi.advanceTimersByTime(100);
    presses.letGo('finger 2');
    expect(heard).toEqual(['+pin0', '+pin1', '+pin2', '+pin3', '-pin2']);
    presses.letGoAll();
    expect(heard.slice(5)).toEqual(['-pin0', '-pin1', '-pin3']);
  });
});

describe('a quick tap', () => {
  it('of 5 ms lasts 100 ms for the board', () => {
    const { presses, heard } = watched();
    presses.hold('finger', ['a']);
    vi.advanceTimersByTime(5);
    presses.letGo('finger');
    vi.advanceTimersByTime(94);
    expect(heard).toEqual(['+a']);
    vi.advanceTimersByTime(1);
    expect(heard).toEqual(['+a', '-a']);
  });

  it('is no longer than the finger where that held for 300 ms', () => {
    const { presses, heard } = watched();
    presses.hold('finger', ['pinLogo']);
    vi.advanceTimersByTime(300);
    presses.letGo('finger');
    expect(heard).toEqual(['+pinLogo', '-pinLogo']);
  });

  it('counts twice when it comes twice within 60 ms, with 60 ms between the two', () => {
    const { presses, heard } = watched();
    for (let tap = 0; tap < 2; tap += 1) {
      presses.hold('finger', ['b']);
      vi.advanceTimersByTime(20);
      presses.letGo('finger');
      vi.advanceTimersByTime(20);
    }
    vi.advanceTimersByTime(20); // 100 ms after the first
    expect(heard).toEqual(['+b', '-b']);
    vi.advanceTimersByTime(59);
    expect(heard).toHaveLength(2);
    vi.advanceTimersByTime(1);
    expect(heard).toEqual(['+b', '-b', '+b']);
    vi.advanceTimersByTime(100);
    expect(heard).toEqual(['+b', '-b', '+b', '-b']);
  });

  it('ends up let go after 20 taps at the same moment, of which 2 count', () => {
    const { presses, heard } = watched();
    for (let tap = 0; tap < 20; tap += 1) {
      presses.hold('finger', ['a']);
      presses.letGo('finger');
    }
    vi.advanceTimersByTime(5000);
    expect(heard).toEqual(['+a', '-a', '+a', '-a']);
  });

  it('lasts 400 ms where the program runs at a quarter of its speed', () => {
    const heard: string[] = [];
    const presses = new Presses(
      { press: (key) => heard.push(`+${key}`), release: (key) => heard.push(`-${key}`) },
      () => 4,
    );
    presses.hold('finger', ['a']);
    presses.letGo('finger');
    vi.advanceTimersByTime(399);
    expect(heard).toEqual(['+a']);
    vi.advanceTimersByTime(1);
    expect(heard).toEqual(['+a', '-a']);
  });

  it('is let go at once when the board goes away, and never again', () => {
    const { presses, heard } = watched();
    presses.hold('finger', ['pin0']);
    presses.end();
    vi.advanceTimersByTime(1000);
    expect(heard).toEqual(['+pin0', '-pin0']);
  });
});
