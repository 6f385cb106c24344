import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { nudged, turnedByEighths } from './arrange';
import { blockTool } from './tools/block-tool';
import { cleared, named, withSize } from './course-edits';
import { describeEdit } from './describe-edit';
import { eraserTool } from './tools/eraser-tool';
import { mazeTool } from './tools/maze-tool';
import { penTool } from './tools/pen-tool';
import { selectTool } from './tools/select-tool';
import { removed } from './selection';
import { startTool } from './tools/start-tool';
import { block, contextOf, course, drag, footprint, stroke, target, wall } from './testing/desk';
import { nothingSelected, type Drag, type Selection, type Tool, type ToolOptions } from './tools/tool';

function said(
  tool: Tool,
  one: Drag,
  scene: Scene,
  options: Partial<ToolOptions> = {},
  selection: Selection = nothingSelected,
) {
  const edit = tool.edit(one, contextOf(scene, options, selection));
  return edit && describeEdit(scene, edit);
}

const of = (...ids: readonly string[]): Selection => ({ ids, robot: false });
const scene = course(
  block('a', [300, 300]),
  block('b', [500, 300]),
  wall('w', [100, 600], [300, 600]),
  stroke('s', [100, 100], [900, 100]),
);

describe('what an edit does', () => {
  it('is drawing a line of some length', () => {
    expect(said(penTool, drag([100, 100], [400, 100], [400, 300]), course(), { penColor: 'red' })).toEqual({
      type: 'drew',
      lengthMm: 500,
      widthMm: 20,
      color: 'red',
    });
  });

  it('is adding something somewhere', () => {
    expect(said(blockTool, drag([400, 200]), course())).toEqual({
      type: 'added',
      kind: 'block',
      count: 1,
      at: [400, 200],
    });
  });

  it('is moving one or several by so much', () => {
    expect(said(selectTool, drag([300, 300], [400, 350]), scene)).toEqual({
      type: 'moved',
      kind: 'block',
      count: 1,
      byMm: [100, 50],
      at: [400, 350],
    });
    const edit = nudged(scene, of('a', 'w', 's'), 0, 10);
    expect(edit && describeEdit(scene, edit)).toEqual({
      type: 'moved',
      kind: 'several',
      count: 3,
      byMm: [0, 10],
      at: null,
    });
  });

  it('is turning by so much', () => {
    for (const id of ['a', 'w', 's']) {
      const edit = turnedByEighths(scene, of(id), 1);
      expect(edit && describeEdit(scene, edit)).toMatchObject({ type: 'turned', count: 1, byDeg: 45 });
    }
    const edit = turnedByEighths(scene, of('a', 'b', 'w'), -2);
    expect(edit && describeEdit(scene, edit)).toEqual({ type: 'turned', kind: 'several', count: 3, byDeg: -90 });
  });

  it('is sizing', () => {
    expect(said(selectTool, drag([325, 325], [375, 345]), scene, {}, of('a'))).toEqual({
      type: 'sized',
      kind: 'block',
      size: [100, 70],
    });
  });

  it('is removing so many of a kind, or all', () => {
    const some = removed(scene, of('a', 'b'));
    expect(some && describeEdit(scene, some)).toEqual({ type: 'removed', kind: 'block', count: 2 });
    const mixed = removed(scene, of('a', 'w'));
    expect(mixed && describeEdit(scene, mixed)).toEqual({ type: 'removed', kind: 'several', count: 2 });
    const all = cleared(scene);
    expect(all && describeEdit(scene, all)).toEqual({ type: 'cleared', count: 4 });
    const last = removed(scene, of('a', 'b', 'w', 's'));
    expect(last && describeEdit(scene, last)).toEqual({ type: 'removed', kind: 'several', count: 4 });
  });

  it('is removing the only wall of a maze, not clearing the course', () => {
    const made = mazeTool.edit(drag([370, 300]), contextOf(course()));
    const maze = made ? applyEdit(course(), made) : course();
    expect(maze.objects).toHaveLength(1);
    expect(said(mazeTool, drag([370, 300]), maze)).toEqual({ type: 'removed', kind: 'wall', count: 1 });
  });

  it('is wiping out a part of a line, in its middle or at its end', () => {
    expect(said(eraserTool, drag([500, 50], [500, 150]), scene)).toEqual({ type: 'erased', count: 1, lengthMm: 50 });
    expect(said(eraserTool, drag([900, 50], [900, 150]), scene)).toEqual({ type: 'erased', count: 1, lengthMm: 25 });
  });

  it('is changing walls that grow together', () => {
    const maze = course(wall('a', [145, 300], [305, 300]), wall('b', [445, 300], [605, 300]));
    expect(said(mazeTool, drag([370, 300]), maze)).toEqual({ type: 'changed', kind: 'wall', count: 2 });
  });

  it('is another start of the robot: only what differs', () => {
    expect(said(startTool, drag([300, 300]), scene)).toEqual({
      type: 'robot',
      at: [300, 300],
      headingDeg: null,
      scale: null,
    });
    expect(said(startTool, drag([300, 300], [300, 500]), scene)).toMatchObject({ at: [300, 300], headingDeg: 90 });
    const back = { ...scene, robot: { ...scene.robot, heading: 90 } };
    expect(said(startTool, drag([600, 526], [800, 450]), back)).toEqual({
      type: 'robot',
      at: null,
      headingDeg: 0,
      scale: null,
    });
  });

  it('is changing the course, or several things at once', () => {
    const name = named(scene, 'Slalom');
    expect(name && describeEdit(scene, name)).toEqual({ type: 'course', what: ['name'] });
    const size = withSize(scene, [500, 400], footprint);
    expect(size && describeEdit(scene, size)).toEqual({ type: 'several' });
  });

  it('may be nothing', () => {
    expect(describeEdit(scene, { type: 'all', edits: [] })).toEqual({ type: 'nothing' });
    expect(describeEdit(scene, { type: 'replace', changes: [{ id: 'a', by: [block('a', [300, 300])] }] })).toEqual({
      type: 'nothing',
    });
    expect(describeEdit(course(target('t', [1, 1])), { type: 'clear' })).toEqual({ type: 'cleared', count: 1 });
  });
});
