import { describe, expect, it } from 'vitest';
import type { Point, SceneObject } from '#scene/scene';
import { block, contextOf, course, drag, freely, newObjects, used, wall } from '../testing/desk';
import { labelTool } from '../tools/label-tool';
import { penTool } from '../tools/pen-tool';
import { selectTool } from '../tools/select-tool';
import { wallTool } from '../tools/wall-tool';
import { zoneTool } from '../tools/zone-tool';

/** A course, and where the first of its blocks is after it was dragged. */
function dragged(to: Point, objects: readonly SceneObject[], from: Point = [100, 100], free = false): Point {
  const scene = course(block('moved', from), ...objects);
  const one = drag(from, [from[0] + 40, from[1]], to);
  const [moved] = used(selectTool, free ? freely(one) : one, contextOf(scene)).objects;
  return (moved as { at: Point }).at;
}

describe('what is moved', () => {
  it('goes with its edge to the edge of a neighbour, also between the lines of the grid', () => {
    // A block of 50 mm stands at 303: its edges at 278 and 328.
    expect(dragged([304, 500], [block('other', [303, 300])])).toEqual([303, 500]);
    expect(dragged([356, 500], [block('other', [303, 300])])).toEqual([353, 500]);
  });

  it('goes with its middle to the middle of a neighbour', () => {
    expect(dragged([500, 306], [block('other', [203, 307])])).toEqual([500, 307]);
  });

  it('goes to the grid where no neighbour is near', () => {
    expect(dragged([504, 708], [block('other', [203, 307])])).toEqual([500, 710]);
  });

  it('goes to the middle of the arena', () => {
    expect(dragged([602, 700], [])).toEqual([600, 700]);
  });

  it('goes as far from a neighbour as that is from the next', () => {
    // 50 mm wide each; from 203 to 271 there are 18 mm between them.
    const row = [block('one', [203, 300]), block('two', [271, 300])];
    expect(dragged([337, 300], row)).toEqual([339, 300]);
    expect(dragged([133, 300], row)).toEqual([135, 300]);
  });

  it('goes amid two neighbours', () => {
    expect(dragged([348, 300], [block('one', [203, 300]), block('two', [497, 300])])).toEqual([350, 300]);
  });

  it('goes where it is put when nothing snaps', () => {
    expect(dragged([304, 501], [block('other', [303, 300])], [100, 100], true)).toEqual([304, 501]);
  });

  it('goes with the end of a line onto the end of another', () => {
    const lines = course(wall('moved', [100, 100], [200, 100]), wall('other', [403, 307], [403, 500]));
    const [moved] = used(selectTool, drag([150, 100], [250, 200], [351, 305]), contextOf(lines)).objects;
    expect(moved).toMatchObject({ from: [303, 307], to: [403, 307] });
  });
});

describe('what is drawn', () => {
  const scene = course(block('other', [303, 307]));
  const drawn = (tool: typeof wallTool, one: ReturnType<typeof drag>, options = {}): SceneObject =>
    newObjects(scene, used(tool, one, contextOf(scene, options)))[0]!;

  it('begins and ends level with the edges of a neighbour', () => {
    expect(drawn(wallTool, drag([329, 500], [329, 600], [331, 700]))).toMatchObject({ from: [328, 500] });
    expect(drawn(wallTool, drag([500, 600], [400, 600], [331, 601]))).toMatchObject({ to: [328, 600] });
    const straight = drawn(penTool, drag([500, 600], [400, 600], [331, 601]), { penShape: 'straight' });
    expect(straight).toMatchObject({ points: [[500, 600], [328, 600]] }); // prettier-ignore
  });

  it('is as large as up to the edges of a neighbour', () => {
    expect(drawn(zoneTool, drag([400, 500], [350, 400], [329, 333]))).toMatchObject({ size: [72, 168] });
  });

  it('is put with its middle level with that of a neighbour', () => {
    expect(drawn(zoneTool, drag([600, 306]))).toMatchObject({ at: [600, 307] });
    expect(drawn(labelTool, drag([600, 306]), { labelText: 'Garage' })).toMatchObject({ at: [600, 307] });
  });
});

describe('what is sized', () => {
  /** The size of a block after its upper right corner was dragged. */
  const sized = (to: Point, angle: number, free = false): Point => {
    const scene = course(block('sized', [100, 100], angle), block('other', [303, 307]));
    const corner: Point = angle === 90 ? [75, 125] : [125, 125];
    const one = drag(corner, [corner[0] + 30, corner[1] + 30], to);
    const context = contextOf(scene, {}, { ids: ['sized'], robot: false });
    const [box] = used(selectTool, free ? freely(one) : one, context).objects;
    return (box as { size: Point }).size;
  };

  it('goes with its corner to the edges of a neighbour, else to whole centimetres', () => {
    expect(sized([276, 284], 0)).toEqual([203, 207]); // from 75 to 278 and to 282
    expect(sized([204, 233], 0)).toEqual([130, 160]);
    expect(sized([276, 284], 0, true)).toEqual([201, 209]);
  });

  it('does so lying on its side, too', () => {
    // Turned by 90°, what was right is up: its corner at the upper left is dragged upward.
    expect(sized([75, 284], 90)).toEqual([207, 50]);
  });
});
