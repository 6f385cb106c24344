import { describe, expect, it } from 'vitest';
import { Trail } from '../../session/run/trail';
import { piecesOf } from './picture-parts';

describe('the path of the robot on a picture', () => {
  it('is parted where the hand lifted the robot; a single place is no path', () => {
    const trail = new Trail();
    trail.add([10, 20, 30, 20, NaN, NaN, 500, 500, NaN, NaN, 600, 100, 600, 200, 600, 300]);
    expect(piecesOf(trail)).toEqual([
      [{ x: 10, y: 20 }, { x: 30, y: 20 }], // prettier-ignore
      [{ x: 600, y: 100 }, { x: 600, y: 200 }, { x: 600, y: 300 }], // prettier-ignore
    ]);
    expect(piecesOf(new Trail())).toEqual([]);
  });
});
