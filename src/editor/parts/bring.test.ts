import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import type { Point, Scene } from '#scene/scene';
import { course, footprint, newObjects, stroke, wall } from '../testing/desk';
import { brought } from './bring';
import { readyPart, type ReadyName } from './ready-parts';

const how = { free: false, reachMm: 8 };

/** The points of the lines that a part becomes when it is let go with its middle at a place. */
function linesOf(scene: Scene, name: ReadyName, [x, y]: Point, more: Partial<typeof how> = {}): readonly unknown[] {
  const made = brought({ scene, footprint }, readyPart(name), { x, y }, { ...how, ...more });
  return newObjects(scene, applyEdit(scene, made!.edit)).map((object) => ('points' in object ? object.points : object));
}

describe('a part that is brought from the shelf', () => {
  it('begins on the grid where nothing is near', () => {
    expect(linesOf(course(), 'straight', [303, 198])).toEqual([[[230, 200], [380, 200]]]); // prettier-ignore
  });

  it('goes with the end of its line onto the end of a line that is there', () => {
    const scene = course(stroke('s', [103, 407], [223, 407]));
    expect(linesOf(scene, 'straight', [301, 409])).toEqual([[[223, 407], [373, 407]]]); // prettier-ignore
    const [curve] = linesOf(scene, 'curve', [295, 481]) as (readonly Point[])[];
    expect([curve![0], curve!.at(-1)]).toEqual([[223, 407], [373, 557]]); // prettier-ignore
  });

  it('goes with a wall onto the end of a wall', () => {
    const scene = course(wall('w', [303, 303], [303, 453]));
    expect(linesOf(scene, 'corridor', [456, 380])).toMatchObject([
      { from: [303, 453], to: [603, 453] },
      { from: [303, 303], to: [603, 303] },
    ]);
  });

  it('lies where it is held when nothing snaps', () => {
    const scene = course(stroke('s', [103, 407], [223, 407]));
    expect(linesOf(scene, 'straight', [301, 409], { free: true })).toEqual([[[226, 409], [376, 409]]]); // prettier-ignore
  });

  it('is a group of its own each time', () => {
    const context = { scene: course(), footprint };
    const first = brought(context, readyPart('gap'), { x: 300, y: 300 }, how)!;
    const scene = applyEdit(context.scene, first.edit);
    const second = brought({ scene, footprint }, readyPart('gap'), { x: 600, y: 600 }, how)!;
    const groups = applyEdit(scene, second.edit).objects.map(({ group }) => group);
    expect(groups).toEqual(['group-1', 'group-1', 'group-2', 'group-2']);
    expect(second.selection.ids).toHaveLength(2);
  });
});
