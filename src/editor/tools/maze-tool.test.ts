import { describe, expect, it } from 'vitest';
import type { Point, Scene } from '#scene/scene';
import { mazeTool } from './maze-tool';
import { contextOf, course, drag, used, wall } from '../testing/desk';

const OPTIONS = { mazeCell: 150, wallThickness: 10 };
const after = (scene: Scene, ...path: readonly Point[]): Scene =>
  used(mazeTool, drag(...path), contextOf(scene, OPTIONS));
const walls = (scene: Scene) =>
  scene.objects.map((object) => (object.type === 'wall' ? [object.id, object.from, object.to] : [object.id]));

/** The edge from [150, 300] to [300, 300], 5 mm longer at both ends so that corners are closed. */
const level = wall('a', [145, 300], [305, 300]);

describe('maze', () => {
  it('puts a wall onto the edge next to which it is tapped', () => {
    expect(walls(after(course(), [220, 310]))).toEqual([['wall-1', [145, 300], [305, 300]]]);
    expect(walls(after(course(), [310, 220]))).toEqual([['wall-1', [300, 145], [300, 305]]]);
  });

  it('takes it away when the same edge is tapped again', () => {
    expect(walls(after(course(level), [220, 310]))).toEqual([]);
  });

  it('does nothing in the middle of a cell, outside the arena or on its rim', () => {
    for (const place of [
      [225, 225],
      [-60, 300],
      [220, 5],
      [1195, 400],
    ] as const)
      expect(mazeTool.edit(drag(place), contextOf(course(), OPTIONS))).toBeNull();
  });

  it('makes one wall of neighbours in line', () => {
    expect(walls(after(course(level), [370, 300]))).toEqual([['a', [145, 300], [455, 300]]]);
    const between = course(level, wall('b', [445, 300], [605, 300]));
    expect(walls(after(between, [370, 300]))).toEqual([['a', [145, 300], [605, 300]]]);
  });

  it('builds walls as high as the tool for walls is set to, and joins them with such alone', () => {
    const low = (scene: Scene): Scene =>
      used(mazeTool, drag([370, 300]), contextOf(scene, { ...OPTIONS, wallHeight: 30 }));
    expect(low(course(level)).objects).toMatchObject([{ id: 'a' }, { id: 'wall-1', height: 30 }]);
    const { objects } = low(course({ ...level, height: 30 } as typeof level));
    expect(objects).toEqual([{ ...wall('a', [145, 300], [455, 300]), height: 30 }]);
    const said = { ...level, height: 250 } as typeof level;
    expect(walls(after(course(said), [370, 300]))).toEqual([['a', [145, 300], [455, 300]]]);
  });

  it('leaves walls apart that meet at a corner or are of another thickness', () => {
    expect(walls(after(course(level), [300, 370]))).toEqual([
      ['a', [145, 300], [305, 300]],
      ['wall-1', [300, 295], [300, 455]],
    ]);
    const thick = course({ ...level, thickness: 20 } as typeof level);
    expect(after(thick, [370, 300]).objects).toHaveLength(2);
  });

  it('parts a long wall when an edge in its middle is tapped', () => {
    expect(walls(after(course(wall('long', [150, 300], [900, 300])), [520, 300]))).toEqual([
      ['long', [150, 300], [455, 300]],
      ['wall-1', [595, 300], [900, 300]],
    ]);
  });

  it('shortens a wall when the edge at its end is tapped', () => {
    expect(walls(after(course(wall('long', [900, 300], [150, 300])), [820, 305]))).toEqual([
      ['long', [150, 300], [755, 300]],
    ]);
  });

  it('knows walls that lie 2 mm beside the grid', () => {
    expect(walls(after(course(wall('a', [152, 298], [299, 298])), [220, 300]))).toEqual([]);
  });

  it('draws along all edges that a drag follows, round corners too', () => {
    expect(walls(after(course(), [160, 302], [450, 296], [455, 600]))).toEqual([
      ['wall-1', [145, 300], [455, 300]],
      ['wall-2', [450, 295], [450, 605]],
    ]);
  });

  it('draws no walls that a drag only crosses', () => {
    expect(walls(after(course(), [160, 302], [760, 302]))).toEqual([['wall-1', [145, 300], [755, 300]]]);
  });

  it('erases along all edges of a drag that began on a wall', () => {
    const scene = course(wall('long', [145, 300], [905, 300]), wall('up', [450, 145], [450, 305]));
    expect(walls(after(scene, [160, 300], [590, 302]))).toEqual([
      ['long', [595, 300], [905, 300]],
      ['up', [450, 145], [450, 305]],
    ]);
  });

  it('ends at the arena’s edge where the last cell is cut off', () => {
    expect(walls(used(mazeTool, drag([1190, 400]), contextOf(course(), { ...OPTIONS, mazeCell: 400 })))).toEqual([
      ['wall-1', [795, 400], [1200, 400]],
    ]);
    const cut = used(mazeTool, drag([1150, 350]), contextOf(course(), { ...OPTIONS, mazeCell: 350 }));
    expect(walls(cut)).toEqual([['wall-1', [1045, 350], [1200, 350]]]);
  });

  it('works for cells of any size', () => {
    for (const mazeCell of [50, 73, 137, 333])
      expect(
        walls(used(mazeTool, drag([1.5 * mazeCell, mazeCell + 3]), contextOf(course(), { ...OPTIONS, mazeCell }))),
      ).toEqual([['wall-1', [mazeCell - 5, mazeCell], [2 * mazeCell + 5, mazeCell]]]);
  });

  it('takes a cell of 0 mm for the smallest there is', () => {
    const tiny = used(mazeTool, drag([60, 99], [1190, 99]), contextOf(course(), { ...OPTIONS, mazeCell: 0 }));
    expect(walls(tiny)).toEqual([['wall-1', [45, 100], [1200, 100]]]);
  });

  it('builds eight walls by eight taps, and none is left after eight more', () => {
    const taps: readonly Point[] = [
      [220, 300],
      [520, 300],
      [300, 370],
      [450, 520],
      [670, 450],
      [900, 700],
      [820, 600],
      [150, 80],
    ];
    const built = taps.reduce((scene, tap) => after(scene, tap), course());
    expect(built.objects).toHaveLength(8);
    expect(taps.reduce((scene, tap) => after(scene, tap), built).objects).toEqual([]);
  });

  it('shows the grid, and the edge that a tap would change', () => {
    const context = contextOf(course(), OPTIONS);
    expect(mazeTool.marks?.(drag([220, 310]), context, false)).toEqual([
      {
        type: 'grid',
        cellMm: 150,
        edge: [
          { x: 150, y: 300 },
          { x: 300, y: 300 },
        ],
      },
    ]);
    const bare = [{ type: 'grid', cellMm: 150, edge: null }];
    expect(mazeTool.marks?.(drag([220, 310], [600, 310]), context, true)).toEqual(bare);
    expect(mazeTool.marksAtRest?.(context)).toEqual(bare);
  });
});
