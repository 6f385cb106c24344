import { describe, expect, it } from 'vitest';

import { feelingInputs } from './feeling';

const action = { type: 'arena-senses', on: true };
const board = (name: string, robot: string) => ({ name, robot });

describe('the boards that feel the arena', () => {
  it('are the one on a robot, but not a single one in the hand', () => {
    expect(feelingInputs([board('1', 'callibot')])).toEqual([{ timeUs: 0, action }]);
    expect(feelingInputs([board('1', 'none')])).toEqual([]);
  });

  it('are all of several, also those in the hand: they hear each other', () => {
    expect(feelingInputs([board('drives', 'callibot'), board('remote', 'none')])).toEqual([
      { timeUs: 0, action },
      { timeUs: 0, device: 'remote', action },
    ]);
  });
});
