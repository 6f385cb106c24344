import { describe, expect, it } from 'vitest';
import { Presses } from './presses';

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
    presses.hold('key', ['logo']);
    presses.hold('key', ['logo']);
    presses.letGo('mouse');
    expect(heard).toEqual(['+logo']);
    expect(presses.isDown('logo')).toBe(true);
  });
});
