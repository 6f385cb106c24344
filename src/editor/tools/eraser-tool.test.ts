import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { inverse } from '#scene/inverse';
import { sceneLimits, type Point, type Scene } from '#scene/scene';
import { eraserTool } from './eraser-tool';
import { block, contextOf, course, drag, stroke, target, used, wall } from '../testing/desk';
import type { Drag } from './tool';

const wipe = (scene: Scene, one: Drag, eraserWidth = 40) =>
  used(eraserTool, one, contextOf(scene, { eraserWidth })).objects;
const take = (scene: Scene, one: Drag) => used(eraserTool, one, contextOf(scene)).objects.map(({ id }) => id);
const going = (scene: Scene, one: Drag, isDown = false) =>
  eraserTool.marks?.(one, contextOf(scene), isDown).flatMap((mark) => (mark.type === 'goes' ? [mark.object.id] : []));

describe('eraser of lines', () => {
  it('cuts a line in two where it crosses it: no ink stays under its 40 mm', () => {
    const scene = course(stroke('a', [100, 300], [900, 300]));
    expect(wipe(scene, drag([500, 200], [500, 400]))).toEqual([
      stroke('a', [100, 300], [470, 300]),
      stroke('stroke-1', [530, 300], [900, 300]),
    ]);
  });

  it('leaves no ink on its way, however fast it went', () => {
    const scene = course(
      ...Array.from({ length: 20 }, (_, i) => stroke(`s${i}`, [100 + 50 * i, 100], [100 + 50 * i, 800])),
    );
    const after = wipe(scene, drag([50, 450], [1150, 450]));
    expect(after).toHaveLength(40);
    for (const object of after)
      if (object.type === 'stroke')
        for (const [, y] of object.points) expect(Math.abs(y - 450)).toBeGreaterThanOrEqual(30);
  });

  it('takes a line away that it covers wholly, and leaves one that it does not touch', () => {
    const scene = course(stroke('short', [500, 300], [520, 300]), stroke('far', [100, 600], [900, 600]));
    expect(wipe(scene, drag([480, 300], [540, 300]))).toEqual([scene.objects[1]]);
  });

  it('dabs when it is tapped', () => {
    const scene = course(stroke('a', [100, 300], [900, 300]));
    expect(wipe(scene, drag([500, 300]))).toHaveLength(2);
  });

  it('takes no walls, blocks or zones where only lines are wanted', () => {
    const scene = course(wall('w', [100, 300], [900, 300]), block('b', [500, 320]), target('t', [500, 300]));
    expect(eraserTool.edit(drag([500, 200], [500, 400]), contextOf(scene, { eraser: 'lines' }))).toBeNull();
  });

  it('wipes off one end of a line 2 mm at a time as in one go', () => {
    const scene = course(stroke('a', [100, 300], [900, 407]));
    const slowly = Array.from({ length: 251 }, (_, i): Point => [900 - 2 * i, Math.round(407 - (i * 2 * 107) / 800)]);
    const [left] = wipe(scene, drag(...slowly));
    if (left?.type !== 'stroke') throw new Error('nothing is left');
    const [, end] = left.points;
    expect(left.points).toHaveLength(2);
    // 500 mm wiped, and 30 mm of reach.
    expect(Math.abs(end![0] - 370)).toBeLessThanOrEqual(2);
    expect(Math.abs(end![1] - (300 + ((end![0] - 100) * 107) / 800))).toBeLessThanOrEqual(1.5);
  });

  it('keeps the longest piece of a line in a course that has no room for both', () => {
    const others = Array.from({ length: sceneLimits.objects - 1 }, (_, i) => block(`b${i}`, [100, 100]));
    const scene = course(stroke('a', [100, 300], [900, 300]), ...others);
    const after = wipe(scene, drag([300, 200], [300, 400]));
    expect(after).toHaveLength(sceneLimits.objects);
    expect(after[0]).toEqual(stroke('a', [330, 300], [900, 300]));
  });

  it('shows how much it covers', () => {
    expect(eraserTool.marks?.(drag([500, 300]), contextOf(course(), { eraserWidth: 60 }), false)).toEqual([
      { type: 'eraser', at: { x: 500, y: 300 }, radiusMm: 30 },
    ]);
  });
});

describe('eraser of things', () => {
  const scene = course(target('t', [500, 300]), stroke('s', [100, 300], [900, 300]), block('b', [500, 300]));

  it('takes the topmost away when it is tapped, and leaves the line below whole', () => {
    expect(take(scene, drag([500, 300]))).toEqual(['t', 's']);
    expect(take(scene, drag([450, 360]))).toEqual(['s', 'b']);
  });

  it('only dabs where a tapped line lies above', () => {
    expect(take(scene, drag([430, 302]))).toEqual(['t', 's', 'stroke-1', 'b']);
  });

  it('takes what is within half the reach of 8 mm', () => {
    expect(take(course(block('b', [500, 300])), drag([530, 300]))).toEqual(['b']);
    expect(take(course(block('b', [500, 300])), drag([528, 300]))).toEqual([]);
  });

  it('takes everything that a drag passes over, however fast', () => {
    const row = course(...Array.from({ length: 10 }, (_, i) => block(`b${i}`, [100 * (i + 1), 300])));
    expect(take(row, drag([50, 300], [850, 300]))).toEqual(['b8', 'b9']);
  });

  it('cuts lines and takes things in one drag, and one undo brings all back', () => {
    const mixed = course(stroke('s', [100, 300], [900, 300]), wall('w', [300, 400], [700, 400]));
    const edit = eraserTool.edit(drag([500, 200], [500, 450]), contextOf(mixed))!;
    const after = applyEdit(mixed, edit);
    expect(after.objects.map(({ id }) => id)).toEqual(['s', 'stroke-1']);
    expect(applyEdit(after, inverse(mixed, edit))).toEqual(mixed);
  });

  it('shows before what a tap would take, and while it is dragged what goes', () => {
    expect(going(scene, drag([500, 300]))).toEqual(['b']);
    expect(going(scene, drag([50, 50]))).toEqual([]);
    expect(going(scene, drag([500, 180], [500, 310]), true)).toEqual(['t', 'b']);
  });

  it('does nothing on an empty place', () => {
    expect(eraserTool.edit(drag([50, 50]), contextOf(scene))).toBeNull();
  });
});
