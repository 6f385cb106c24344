import { describe, expect, it } from 'vitest';
import type { League } from '#scene/league/league';
import { markPlaces } from './mark-places';
import { pointsAtStart } from './score-sheet';

const league: League = {
  rules: 'line-2025',
  tiles: [
    { at: [150, 150], heading: 0 },
    { at: [450, 150], heading: 0, gaps: 1 },
    { at: [750, 150], heading: 90, checkpoint: true },
    { at: [750, 450], heading: 90 },
  ],
};

describe('the marks of a scored line', () => {
  it('are numbers of checkpoints and points, those of one tile together, beside the line', () => {
    expect(markPlaces(league, pointsAtStart(league).lines)).toEqual([
      { key: 'checkpoint 2', kind: 'checkpoint', text: '1', at: { x: 845, y: 55 } }, // the outer corner of the bend
      { key: 'points 0', kind: 'earned', text: '5', at: { x: 150, y: 55 } },
      { key: 'points 1', kind: 'open', text: '10', at: { x: 450, y: 55 } },
      { key: 'points 2', kind: 'open', text: '10', at: { x: 655, y: 245 } },
      { key: 'points 3', kind: 'open', text: '65', at: { x: 845, y: 530 } }, // 5 for the tile, 60 for the end
    ]);
  });
});
