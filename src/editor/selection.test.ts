import { describe, expect, it } from 'vitest';
import { only, removed, selectAll, thingsAt, thingsIn, toggled } from './selection';
import { block, course, footprint, stroke, target, wall } from './testing/desk';
import type { SceneObject } from '#scene/scene';

const round: SceneObject = { ...target('round', [300, 300]), round: true } as SceneObject;

describe('what is at a place', () => {
  it('lists solid things before lines, lines before zones, and later ones first', () => {
    const scene = course(
      block('a', [300, 300]),
      block('b', [310, 300]),
      stroke('s', [100, 300], [500, 300]),
      target('t', [300, 300]),
    );
    expect(thingsAt(scene, { x: 305, y: 300 }, 5)).toEqual(['b', 'a', 's', 't']);
  });

  it('takes a line that is 5 mm away rather than the zone that it crosses', () => {
    const scene = course(target('t', [300, 300]), stroke('s', [100, 300], [500, 300]));
    expect(thingsAt(scene, { x: 300, y: 315 }, 8)).toEqual(['s', 't']);
    expect(thingsAt(scene, { x: 300, y: 315 }, 4)).toEqual(['t']);
  });

  it('takes the nearest of those within reach', () => {
    const scene = course(wall('far', [100, 112], [400, 112]), wall('near', [100, 90], [400, 90]));
    expect(thingsAt(scene, { x: 200, y: 98 }, 20)).toEqual(['near', 'far']);
  });

  it('knows a line by the distance to it, not by the rectangle around it', () => {
    const scene = course(stroke('s', [100, 100], [500, 500]));
    expect(thingsAt(scene, { x: 400, y: 200 }, 20)).toEqual([]);
    expect(thingsAt(scene, { x: 310, y: 300 }, 0)).toEqual(['s']);
  });

  it('knows that the corners of a round zone do not belong to it', () => {
    expect(thingsAt(course(round), { x: 390, y: 390 }, 5)).toEqual([]);
    expect(thingsAt(course(round), { x: 368, y: 368 }, 0)).toEqual(['round']);
  });

  it('knows a turned block', () => {
    expect(thingsAt(course(block('b', [300, 300], 1)), { x: 333, y: 300 }, 0)).toEqual(['b']);
    expect(thingsAt(course(block('b', [300, 300], 1)), { x: 323, y: 323 }, 0)).toEqual([]);
  });

  it('takes the robot first, if there is one', () => {
    const scene = course(block('b', [600, 450]));
    expect(thingsAt(scene, { x: 600, y: 450 }, 5, footprint)).toEqual([null, 'b']);
    expect(thingsAt(scene, { x: 600, y: 450 }, 5)).toEqual(['b']);
  });
});

describe('what a frame touches', () => {
  it('is whatever lies in it or crosses its edge', () => {
    const scene = course(
      block('in', [300, 300]),
      block('half', [395, 300]),
      block('out', [430, 300]),
      stroke('crosses', [100, 250], [900, 350]),
      stroke('around', [100, 100], [100, 500], [500, 500], [500, 100], [100, 100]),
    );
    expect(thingsIn(scene, { x: 400, y: 400 }, { x: 200, y: 200 })).toEqual({
      ids: ['in', 'half', 'crosses'],
      robot: false,
    });
  });

  it('takes the ink of a line as wide as it is', () => {
    const scene = course(stroke('s', [100, 300], [500, 300]));
    expect(thingsIn(scene, { x: 200, y: 309 }, { x: 300, y: 400 }).ids).toEqual(['s']);
    expect(thingsIn(scene, { x: 200, y: 311 }, { x: 300, y: 400 }).ids).toEqual([]);
  });

  it('does not catch a turned block by the empty corner of the rectangle around it', () => {
    const scene = course(block('b', [300, 300], 1));
    expect(thingsIn(scene, { x: 326, y: 326 }, { x: 400, y: 400 }).ids).toEqual([]);
    expect(thingsIn(scene, { x: 310, y: 310 }, { x: 400, y: 400 }).ids).toEqual(['b']);
  });

  it('catches the start of the robot', () => {
    expect(thingsIn(course(), { x: 650, y: 470 }, { x: 700, y: 600 }, footprint).robot).toBe(true);
    expect(thingsIn(course(), { x: 670, y: 470 }, { x: 700, y: 600 }, footprint).robot).toBe(false);
  });
});

describe('selection', () => {
  const scene = course(block('a', [300, 300]), block('b', [500, 300]));

  it('can be all there is', () => {
    expect(selectAll(scene)).toEqual({ ids: ['a', 'b'], robot: true });
    expect(selectAll(scene, false).robot).toBe(false);
  });

  it('takes a thing in and out', () => {
    expect(toggled({ ids: ['a'], robot: false }, only('b'))).toEqual({ ids: ['a', 'b'], robot: false });
    expect(toggled({ ids: ['a'], robot: true }, only(null))).toEqual({ ids: ['a'], robot: false });
  });

  it('removes its objects but never the start of the robot', () => {
    expect(removed(scene, { ids: ['b', 'gone'], robot: true })).toEqual({ type: 'remove', ids: ['b'] });
    expect(removed(scene, { ids: [], robot: true })).toBeNull();
  });
});
