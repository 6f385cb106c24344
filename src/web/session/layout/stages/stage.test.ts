import { describe, expect, it } from 'vitest';

import { sightOf, STAGES } from './stage';

describe('how much of the app is in sight', () => {
  it('never hides the board', () => {
    for (const stage of STAGES) expect(sightOf(stage).showBoard).toBe(true);
  });

  it('builds where all is in sight, and drives with the robot', () => {
    expect([sightOf('all').showTools, sightOf('robot').showTools]).toEqual([true, false]);
  });
});
