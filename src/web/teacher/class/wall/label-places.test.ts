import { describe, expect, it } from 'vitest';

import { labelPlaces } from './label-places';

const picture = { width: 400, height: 300 };
const dot = (x: number, y: number) => ({ x, y, radius: 10, label: { width: 60, height: 20 } });
/** The top left corner of each name. */
const corners = (...dots: readonly ReturnType<typeof dot>[]) =>
  labelPlaces(dots, picture).map((box) => box && [box.left, box.top]);

describe('the names of robots in the picture of all ways', () => {
  it('stand at the right of their robots, and at the left where the picture ends', () => {
    expect(corners(dot(100, 100), dot(380, 200))).toEqual([[110, 90], [310, 190]]); // prettier-ignore
  });

  it('never lie over one another: of six robots in one place four have names around it', () => {
    const at = dot(200, 150);
    expect(corners(at, at, at, at, at, at)).toEqual([[210, 140], [130, 140], [170, 120], [170, 160], null, null]); // prettier-ignore
  });

  it('stay inside of the picture in its corner', () => {
    expect(corners(dot(395, 5), dot(200, 295))).toEqual([[325, 0], [210, 280]]); // prettier-ignore
  });
});
