import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import type { Point, Scene } from '#scene/scene';
import { contextOf, course, drag, freely, stroke, used } from '../testing/desk';
import { penTool } from '../tools/pen-tool';
import { selectTool } from '../tools/select-tool';
import type { Selection } from '../tools/tool';
import { closedLines, coarsened, joinedLines, restyled, smoothed } from './line-acts';

const straight = { penShape: 'straight' } as const;
const selected = (...ids: readonly string[]): Selection => ({ ids, robot: false });
const linesOf = ({ objects }: Scene) =>
  objects.filter((object) => object.type === 'stroke').map(({ id, points }) => ({ id, points }));

describe('ends of lines', () => {
  const a = stroke('a', [100, 100], [300, 100]);

  it('become one line when a new one begins where another ends, whatever its direction', () => {
    const after = used(penTool, drag([302, 98], [300, 300]), contextOf(course(a), straight));
    expect(linesOf(after)).toEqual([{ id: 'a', points: [[100, 100], [300, 100], [300, 300]] }]); // prettier-ignore
  });

  it('become one line of three when a new one lies between two', () => {
    const scene = course(a, stroke('b', [500, 100], [700, 100]));
    const after = used(penTool, drag([300, 100], [500, 100]), contextOf(scene, straight));
    expect(after.objects).toHaveLength(1);
    expect(after.objects[0]).toMatchObject({ points: [[100, 100], [300, 100], [500, 100], [700, 100]] }); // prettier-ignore
  });

  it('close a line whose both ends a new one joins', () => {
    const scene = course(stroke('a', [100, 100], [300, 100], [300, 300]));
    const after = used(penTool, drag([300, 300], [100, 100]), contextOf(scene, straight));
    expect(linesOf(after)).toEqual([
      { id: 'a', points: [[300, 300], [100, 100], [300, 100], [300, 300]] }, // prettier-ignore
    ]);
  });

  it('attract a line drawn by hand that comes within reach of them', () => {
    const after = used(penTool, drag([305, 103], [320, 200], [300, 300]), contextOf(course(a)));
    expect(after.objects).toHaveLength(1);
    expect(after.objects[0]).toMatchObject({ points: expect.arrayContaining([[300, 100]]) as Point[] });
  });

  it('stay apart when the colour or the width differs, and when the magnet is off', () => {
    const one = drag([300, 100], [300, 300]);
    expect(used(penTool, one, contextOf(course(a), { ...straight, penColor: 'red' })).objects).toHaveLength(2);
    expect(used(penTool, one, contextOf(course(a), { ...straight, penWidth: 15 })).objects).toHaveLength(2);
    expect(used(penTool, freely(one), contextOf(course(a), straight)).objects).toHaveLength(2);
  });

  it('become one when an end is dragged to the end of another line', () => {
    const scene = course(a, stroke('b', [330, 130], [500, 130]));
    const after = used(selectTool, drag([300, 100], [328, 129]), contextOf(scene, {}, selected('a')));
    expect(linesOf(after)).toEqual([{ id: 'a', points: [[100, 100], [330, 130], [500, 130]] }]); // prettier-ignore
  });
});

describe('what the head does with lines', () => {
  const bent = stroke('a', [100, 100], [300, 100], [300, 300]);
  const done = (act: typeof smoothed, scene: Scene, ...ids: readonly string[]): Scene => {
    const edit = act(scene, selected(...ids));
    if (!edit) throw new Error('nothing to do');
    return applyEdit(scene, edit);
  };

  it('gives several lines one colour and one width, in one edit', () => {
    const scene = course(bent, stroke('b', [0, 0], [9, 9]));
    const edit = restyled(scene, selected('a', 'b'), { color: 'red', width: 30 });
    expect(applyEdit(scene, edit!).objects).toMatchObject([
      { color: 'red', width: 30 },
      { color: 'red', width: 30 },
    ]);
    expect(restyled(scene, selected('a'), { color: 'black' })).toBeNull();
  });

  it('smooths a line a step further each time, and never moves its ends', () => {
    const once = done(smoothed, course(bent), 'a');
    const twice = done(smoothed, once, 'a');
    const inner = (scene: Scene): number => Math.max(...linesOf(scene)[0]!.points.map(([x, y]) => x - y));
    expect(inner(once)).toBeLessThan(200);
    expect(inner(twice)).toBeLessThan(inner(once));
    for (const { points } of [linesOf(once)[0]!, linesOf(twice)[0]!])
      expect([points[0], points[points.length - 1]]).toEqual([
        [100, 100],
        [300, 300],
      ]);
  });

  it('leaves points out until only the shape is left', () => {
    const wavy = stroke('a', ...Array.from({ length: 50 }, (_, i): Point => [100 + 10 * i, 100 + 3 * (i % 2)]));
    const after = done(coarsened, course(wavy), 'a');
    expect(linesOf(after)[0]!.points.length).toBeLessThan(10);
    expect(coarsened(course(bent), selected('a'))).toBeNull();
  });

  it('joins two lines at their nearest ends', () => {
    const after = done(joinedLines, course(bent, stroke('b', [700, 300], [320, 300])), 'a', 'b');
    expect(linesOf(after)).toEqual([
      { id: 'a', points: [[100, 100], [300, 100], [300, 300], [320, 300], [700, 300]] }, // prettier-ignore
    ]);
  });

  it('closes a line with a bend', () => {
    const after = done(closedLines, course(bent), 'a');
    expect(linesOf(after)[0]!.points).toEqual([[100, 100], [300, 100], [300, 300], [100, 100]]); // prettier-ignore
    expect(closedLines(after, selected('a'))).toBeNull();
  });
});
