import { describe, expect, it } from 'vitest';
import type { SceneObject } from '#scene/scene';
import { nudged } from '../arrange';
import { block, contextOf, course, drag, freely, wall } from '../testing/desk';
import { blockTool } from '../tools/block-tool';
import { rotateTool } from '../tools/rotate-tool';
import { selectTool } from '../tools/select-tool';
import { startTool } from '../tools/start-tool';
import type { Drag, Tool, ToolContext } from '../tools/tool';
import { wallTool } from '../tools/wall-tool';
import { zoneTool } from '../tools/zone-tool';
import { figuresOf, inkReading, type Figures } from './figures';

const figuresWith = (tool: Tool, one: Drag, context: ToolContext): Figures =>
  figuresOf(tool.edit(one, context), context, { tool, drag: one });

const contextWith = (...objects: readonly SceneObject[]): ToolContext => contextOf(course(...objects));

const distancesIn = ({ marks }: Figures): readonly number[] =>
  marks.flatMap((mark) =>
    mark.type === 'distance' ? [Math.abs(mark.to.x - mark.from.x) + Math.abs(mark.to.y - mark.from.y)] : [],
  );

describe('figures', () => {
  it('tell a wall’s length and direction while it is drawn', () => {
    const { reading } = figuresWith(wallTool, drag([100, 100], [300, 100], [300, 300]), contextWith());
    expect(reading).toMatchObject({ type: 'length', deg: 45, from: { x: 100, y: 100 } });
    expect(reading).toHaveProperty('mm', Math.sqrt(2) * 200);
  });

  it('tell width and height of a field while it is drawn', () => {
    const { reading } = figuresWith(zoneTool, drag([100, 100], [300, 200], [400, 300]), contextWith());
    expect(reading).toEqual({ type: 'size', width: 300, height: 200, from: { x: 100, y: 100 } });
  });

  it('tell how far something is moved, and many things as one', () => {
    const context = contextWith(block('a', [300, 300]), block('b', [500, 300]));
    const one = drag([300, 300], [340, 300], [400, 350]);
    expect(figuresWith(selectTool, one, context).reading).toEqual({ type: 'moved', by: { x: 100, y: 50 } });
    const both = { ...context, selection: { ids: ['a', 'b'], robot: true } };
    expect(figuresWith(selectTool, one, both).reading).toEqual({ type: 'moved', by: { x: 100, y: 50 } });
  });

  it('tell by how much something is turned', () => {
    const context = contextWith(wall('a', [300, 300], [500, 300]));
    const turned = figuresWith(rotateTool, drag([480, 300], [450, 400], [400, 400]), context);
    expect(turned.reading).toEqual({ type: 'turned', byDeg: 90, about: { x: 400, y: 300 } });
  });

  it('tell a wall’s length from the end that stays when the other is moved', () => {
    const context = { ...contextWith(wall('a', [300, 300], [500, 300])), selection: { ids: ['a'], robot: false } };
    const { reading } = figuresWith(selectTool, drag([300, 300], [250, 300], [200, 300]), context);
    expect(reading).toEqual({ type: 'length', mm: 300, deg: 180, from: { x: 500, y: 300 } });
  });

  it('tell the direction in which the robot starts', () => {
    const { reading } = figuresWith(startTool, drag([700, 500], [700, 600], [700, 700]), contextWith());
    expect(reading).toMatchObject({ type: 'heading', deg: 90 });
  });

  it('tell how long a line is that is drawn freely', () => {
    expect(inkReading([{ x: 0, y: 0 }, { x: 30, y: 40 }, { x: 30, y: 90 }])).toMatchObject({ mm: 100, deg: null }); // prettier-ignore
  });

  it('tell how far the nearest neighbour is, or the edge of the arena where that is nearer', () => {
    const figures = figuresWith(blockTool, drag([600, 700]), contextOf(course(block('a', [420, 700]))));
    // Blocks of 50 mm: 130 mm between them, and 175 mm to the edge above.
    expect(distancesIn(figures)).toEqual([130, 175]);
  });

  it('tell all distances that are equal', () => {
    const context = contextWith(block('a', [300, 300]), block('b', [400, 300]));
    const figures = figuresWith(blockTool, drag([500, 300]), context);
    expect(figures.marks.filter((mark) => mark.type === 'distance' && mark.equal)).toHaveLength(2);
    expect(distancesIn(figures).slice(0, 2)).toEqual([50, 50]);
  });

  it('show a line through the middles of what lies level, and none when nothing snaps', () => {
    const context = contextWith(block('a', [300, 310]));
    const one = drag([600, 311]);
    const guide = { type: 'guide', from: { x: 275, y: 310 }, to: { x: 625, y: 310 } };
    expect(figuresWith(blockTool, one, context).marks).toContainEqual(guide);
    const free = figuresWith(blockTool, freely(drag([600, 310])), context);
    expect(free.marks.some(({ type }) => type === 'guide')).toBe(false);
  });

  it('are there for arrow keys, too', () => {
    const context = { ...contextWith(block('a', [300, 310])), selection: { ids: ['a'], robot: false } };
    const edit = nudged(context.scene, context.selection, 20, 0);
    expect(figuresOf(edit, context, null).reading).toEqual({ type: 'moved', by: { x: 20, y: 0 } });
  });
});
