import { describe, expect, it } from 'vitest';
import type { Point } from '#scene/scene';
import { contextOf, course, drag, freely, newObjects, taps, used, wall } from '../testing/desk';
import { wallTool } from './wall-tool';

const drawn = (path: readonly [Point, Point], scene = course(), options = {}) =>
  newObjects(scene, used(wallTool, drag(...path), contextOf(scene, options)));

describe('wall', () => {
  it('goes from where the drag began to where it ended, with the chosen thickness', () => {
    expect(
      drawn(
        [
          [100, 100],
          [400, 100],
        ],
        course(),
        { wallThickness: 16 },
      ),
    ).toEqual([{ type: 'wall', id: 'wall-1', from: [100, 100], to: [400, 100], thickness: 16 }]);
  });

  it('is as high as the tool is set to; a usual height is left out', () => {
    const path = [[100, 100], [400, 100]] as const; // prettier-ignore
    expect(drawn(path, course(), { wallHeight: 30 })).toMatchObject([{ height: 30 }]);
    expect(drawn(path, course(), { wallHeight: 250 })).toEqual([wall('wall-1', ...path)]);
  });

  it('has the colour that the tool is set to', () => {
    const path = [[100, 100], [400, 100]] as const; // prettier-ignore
    expect(drawn(path, course(), { wallColor: 'blue' })).toEqual([{ ...wall('wall-1', ...path), color: 'blue' }]);
  });

  it('lies level when it is drawn 10° askew', () => {
    expect(
      drawn([
        [100, 100],
        [400, 150],
      ]),
    ).toMatchObject([{ from: [100, 100], to: [400, 100] }]);
  });

  it('lies at exactly 45° when it is drawn 40° askew', () => {
    expect(
      drawn([
        [100, 100],
        [300, 270],
      ]),
    ).toMatchObject([{ from: [100, 100], to: [290, 290] }]);
  });

  it('begins and ends on the 10 mm grid', () => {
    expect(
      drawn([
        [103, 98],
        [398, 104],
      ]),
    ).toMatchObject([{ from: [100, 100], to: [400, 100] }]);
  });

  it('joins the end of another wall that is 6 mm away', () => {
    const scene = course(wall('w', [700, 305], [700, 600]));
    expect(
      drawn(
        [
          [400, 300],
          [695, 302],
        ],
        scene,
      ),
    ).toMatchObject([{ from: [400, 300], to: [700, 305] }]);
  });

  it('ends on the middle line of a wall that it runs into', () => {
    const scene = course(wall('w', [703, 100], [703, 600]));
    expect(
      drawn(
        [
          [400, 300],
          [698, 304],
        ],
        scene,
      ),
    ).toMatchObject([{ from: [400, 300], to: [703, 300] }]);
  });

  it('begins on the middle line of another wall', () => {
    const scene = course(wall('w', [703, 100], [703, 600]));
    expect(
      drawn(
        [
          [706, 350],
          [900, 352],
        ],
        scene,
      ),
    ).toMatchObject([{ from: [703, 350], to: [900, 350] }]);
  });

  it('takes any direction and any millimetre when it is free', () => {
    const scene = course(wall('w', [703, 100], [703, 600]));
    const after = used(wallTool, freely(drag([103, 98], [698, 137])), contextOf(scene));
    expect(newObjects(scene, after)).toMatchObject([{ from: [103, 98], to: [698, 137] }]);
    expect(
      drawn(
        [
          [103, 98],
          [698, 137],
        ],
        scene,
        { wallSnaps: false },
      ),
    ).toMatchObject([{ from: [103, 98], to: [698, 137] }]);
  });

  it('ends at the edge of the arena when the drag goes on outside', () => {
    expect(
      drawn([
        [1000, 500],
        [1700, 500],
      ]),
    ).toMatchObject([{ from: [1000, 500], to: [1200, 500] }]);
  });

  it('is not put by a tap, nor by a drag of 3 mm, nor outside the arena', () => {
    const scene = course();
    expect(wallTool.edit(drag([100, 100]), contextOf(scene))).toBeNull();
    expect(wallTool.edit(drag([100, 100], [103, 100]), contextOf(scene))).toBeNull();
    expect(wallTool.edit(drag([-100, 100], [-100, 400]), contextOf(scene))).toBeNull();
  });

  it('shows where it has snapped to', () => {
    const scene = course(wall('w', [700, 305], [700, 600]));
    expect(wallTool.marks?.(drag([400, 300], [695, 302]), contextOf(scene), true)).toEqual([
      { type: 'snap', at: { x: 700, y: 305 } },
    ]);
    expect(wallTool.marks?.(drag([702, 309]), contextOf(scene), false)).toEqual([
      { type: 'snap', at: { x: 700, y: 305 } },
    ]);
  });
});

describe('walls by clicks', () => {
  const corners = (...places: readonly Point[]) =>
    newObjects(course(), used(wallTool, taps(...places), contextOf(course()))).map((object) =>
      object.type === 'wall' ? [object.from, object.to] : [],
    );

  it('stand from corner to corner', () => {
    expect(corners([100, 100], [400, 100], [402, 298])).toEqual([
      [
        [100, 100],
        [400, 100],
      ],
      [
        [400, 100],
        [400, 300],
      ],
    ]);
  });

  it('close to a polygon on the first corner, and end there', () => {
    const closing = taps([100, 100], [400, 100], [400, 300], [102, 101]);
    expect(wallTool.goesOn?.(closing, contextOf(course()))).toBe(false);
    expect(corners([100, 100], [400, 100], [400, 300], [102, 101])[2]).toEqual([
      [400, 300],
      [100, 100],
    ]);
  });

  it('begin with a tap, never with a drag', () => {
    expect(wallTool.goesOn?.(drag([100, 100]), contextOf(course()))).toBe(true);
    expect(wallTool.goesOn?.(drag([100, 100], [400, 100]), contextOf(course()))).toBe(false);
  });
});
