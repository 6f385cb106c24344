import { describe, expect, it } from 'vitest';
import { BOARD_KEYS, isButtonKey, Presses } from './presses';

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
    presses.letGo('finger 1');
    expect(heard).toEqual(['+a']);
    presses.letGo('finger 2');
    expect(heard).toEqual(['+a', '-a']);
  });

  it('can be held together: 2 fingers on A and B, or 1 on A + B', () => {
    const { presses, heard } = watched();
    presses.hold('finger 1', ['a']);
    presses.hold('finger 2', ['b']);
    presses.letGoAll();
    presses.hold('finger 1', ['a', 'b']);
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
    presses.letGo('finger 2');
    expect(heard).toEqual(['+pin0', '+pin1', '+pin2', '+pin3', '-pin2']);
    presses.letGoAll();
    expect(heard.slice(5)).toEqual(['-pin0', '-pin1', '-pin3']);
  });
});
