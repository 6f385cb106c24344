import { describe, expect, it } from 'vitest';
import type { Scene } from '#scene/scene';
import { rotateTool } from './rotate-tool';
import { block, contextOf, course, drag, freely, mover, stroke, used, wall } from '../testing/desk';
import { nothingSelected, type Drag, type Selection } from './tool';

const after = (scene: Scene, one: Drag, selection: Selection = nothingSelected): Scene =>
  used(rotateTool, one, contextOf(scene, {}, selection));

const taps = (scene: Scene, one: Drag, count: number, selection?: Selection): Scene =>
  Array.from({ length: count }).reduce<Scene>((before) => after(before, one, selection), scene);

describe('rotate', () => {
  it('turns a block by 45° counter-clockwise at each tap, eight taps all round', () => {
    const scene = course(block('b', [300, 300]));
    expect(after(scene, drag([310, 300])).objects).toEqual([block('b', [300, 300], 1)]);
    expect(taps(scene, drag([310, 300]), 8)).toEqual(scene);
  });

  it('turns a wall about its middle', () => {
    expect(taps(course(wall('w', [100, 300], [300, 300])), drag([200, 300]), 2).objects).toEqual([
      wall('w', [200, 200], [200, 400]),
    ]);
  });

  it.each([
    [100, 45],
    [101, 44],
    [50, 63],
    [7, 200],
  ])('brings a wall of %i × %i mm back to its place within 1 mm after eight taps', (width, height) => {
    const scene = course(wall('w', [300, 300], [300 + width, 300 + height]));
    const at = drag([300 + width / 2, 300 + height / 2]);
    const [turned] = taps(scene, at, 8).objects;
    if (turned?.type !== 'wall') throw new Error('no wall');
    expect(Math.abs(turned.from[0] - 300)).toBeLessThanOrEqual(1);
    expect(Math.abs(turned.from[1] - 300)).toBeLessThanOrEqual(1);
    expect(Math.abs(turned.to[0] - 300 - width)).toBeLessThanOrEqual(1);
    expect(Math.abs(turned.to[1] - 300 - height)).toBeLessThanOrEqual(1);
    expect(taps(scene, at, 80).objects).toEqual(taps(scene, at, 16).objects);
  });

  it('turns a stroke about the middle of its ink', () => {
    const scene = course(stroke('s', [300, 300], [400, 300], [400, 400], [300, 400], [300, 300]));
    expect(after(scene, drag([300, 300])).objects).toEqual([
      stroke('s', [350, 279], [421, 350], [350, 421], [279, 350], [350, 279]),
    ]);
  });

  it('turns the track of a mover with it', () => {
    expect(taps(course(mover('m', [300, 300], [500, 300])), drag([300, 300]), 2).objects).toEqual([
      { ...mover('m', [300, 300], [300, 500]), angle: 90 },
    ]);
  });

  it('turns the start of the robot by 45° at a tap, in steps of 15° or 1° by a drag', () => {
    expect(after(course(), drag([600, 450])).robot.heading).toBe(45);
    expect(after(course(), drag([640, 450], [640, 472])).robot.heading).toBe(30);
    expect(after(course(), freely(drag([640, 450], [640, 472]))).robot.heading).toBe(29);
  });

  it('turns a wall by a drag in steps of 15°, in any direction when it is free', () => {
    const scene = course(wall('w', [300, 300], [500, 300]));
    expect(after(scene, drag([480, 300], [470, 370])).objects).toEqual([wall('w', [330, 230], [471, 371])]);
    expect(after(scene, drag([480, 300], [470, 340])).objects).toEqual([wall('w', [314, 250], [487, 350])]);
    const [turned] = after(scene, freely(drag([480, 300], [470, 336]))).objects;
    if (turned?.type !== 'wall') throw new Error('no wall');
    // 27° of a wall of 200 mm: 178 × 91 mm.
    expect([turned.to[0] - turned.from[0], turned.to[1] - turned.from[1]]).toEqual([178, 91]);
  });

  it('turns what is selected together about the common middle', () => {
    const scene = course(block('a', [300, 300]), block('b', [500, 300]), block('c', [800, 800]));
    const both: Selection = { ids: ['a', 'b'], robot: false };
    expect(after(scene, drag([500, 300]), both).objects).toEqual([
      block('a', [329, 229], 1),
      block('b', [471, 371], 1),
      scene.objects[2],
    ]);
    expect(rotateTool.select?.(drag([500, 300]), contextOf(scene, {}, both), scene)).toEqual(both);
  });

  it('turns something else alone, and selects it', () => {
    const scene = course(block('a', [300, 300]), block('c', [800, 800]));
    const context = contextOf(scene, {}, { ids: ['a'], robot: false });
    expect(used(rotateTool, drag([800, 800]), context).objects).toEqual([scene.objects[0], block('c', [800, 800], 1)]);
    expect(rotateTool.select?.(drag([800, 800]), context, scene)).toEqual({ ids: ['c'], robot: false });
  });

  it('does nothing on an empty place', () => {
    expect(rotateTool.edit(drag([50, 50]), contextOf(course()))).toBeNull();
  });
});
