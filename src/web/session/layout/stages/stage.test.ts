import { describe, expect, it } from 'vitest';

import { defaultSettings } from '../../work/settings/settings';
import { sightOf, STAGES, stageOf } from './stage';

const first = defaultSettings('de');

describe('how much of the app is in sight', () => {
  it('is everything on a first visit, and on a phone the robot without the tools', () => {
    expect(stageOf(first, true)).toBe('all');
    expect(stageOf(first, false)).toBe('robot');
  });

  it('is what was chosen, wherever one comes from', () => {
    for (const before of STAGES)
      for (const stage of STAGES)
        for (const isUnfolded of [true, false])
          expect(stageOf({ ...first, ...sightOf(before), ...sightOf(stage) }, isUnfolded)).toBe(stage);
  });

  it('follows what shows the arena or unfolds the tools by another way', () => {
    const alone = { ...first, ...sightOf('board') };
    expect(stageOf({ ...alone, showArena: true, showTools: false }, true)).toBe('robot');
    const robot = { ...first, ...sightOf('robot') };
    expect(stageOf({ ...robot, showTools: true }, false)).toBe('all');
  });

  it('never hides the board', () => {
    for (const stage of STAGES) expect(sightOf(stage).showBoard).toBe(true);
  });
});
