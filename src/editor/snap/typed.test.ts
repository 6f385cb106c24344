import { describe, expect, it } from 'vitest';
import type { Scene, SceneObject } from '#scene/scene';
import { block, contextOf, course, drag, used, wall } from '../testing/desk';
import { labelTool } from '../tools/label-tool';
import { rotateTool } from '../tools/rotate-tool';
import { selectTool } from '../tools/select-tool';
import { startTool } from '../tools/start-tool';
import type { Drag, Selection, Tool } from '../tools/tool';
import { wallTool } from '../tools/wall-tool';
import { zoneTool } from '../tools/zone-tool';
import { typedDrag, typedNumbers, typedText } from './typed';

describe('what is typed during a drag', () => {
  const typing = (...keys: readonly string[]): string | null =>
    keys.reduce<string | null>((text, key) => (text === null ? null : typedText(text, key)), '');

  it('begins with a digit, and has a second number after Tab, x or *', () => {
    expect(typing('3', '0')).toBe('30');
    expect(typing('3', '0', 'Tab', '2', '0')).toBe('30 × 20');
    expect(typing('3', ',', '5', 'x', '2', 'x')).toBe('3,5 × 2');
    expect(typing('x')).toBeNull();
    expect(typing('a')).toBeNull();
  });

  it('is corrected with the backspace key, down to nothing', () => {
    expect(typing('3', '0', '*', '2', 'Backspace', 'Backspace', 'Backspace')).toBe('3');
    expect(typing('3', 'Backspace')).toBe('');
  });

  it('is read with a point or a comma, as far as it is complete', () => {
    expect(typedNumbers('12,5 × 3.5')).toEqual([12.5, 3.5]);
    expect(typedNumbers('30 × ')).toEqual([30]);
    expect(typedNumbers('-')).toEqual([]);
  });
});

describe('a drag with typed numbers', () => {
  const nothing: Selection = { ids: [], robot: false };

  function after(
    tool: Tool,
    one: Drag,
    numbers: readonly number[],
    objects: readonly SceneObject[] = [],
    selection = nothing,
  ): Scene {
    const context = contextOf(course(...objects), { labelText: 'Garage' }, selection);
    return used(tool, typedDrag(tool, one, context, numbers), context);
  }
  const first = (scene: Scene): SceneObject => scene.objects[0]!;

  it('draws a wall as long as was typed, from where it snapped, in its direction', () => {
    expect(first(after(wallTool, drag([103, 98], [200, 100], [260, 101]), [31.7]))).toMatchObject({ from: [100, 100], to: [417, 100] }); // prettier-ignore
    expect(first(after(wallTool, drag([600, 700], [500, 700], [400, 702]), [25]))).toMatchObject({ from: [600, 700], to: [350, 700] }); // prettier-ignore
    expect(first(after(wallTool, drag([100, 100], [200, 190], [200, 200]), [10]))).toMatchObject({ from: [100, 100], to: [171, 171] }); // prettier-ignore
  });

  it('draws a wall that goes so far to the side and so far up', () => {
    expect(first(after(wallTool, drag([600, 700], [500, 600], [500, 600]), [30, 20]))).toMatchObject({ from: [600, 700], to: [300, 500] }); // prettier-ignore
  });

  it('draws a wall to the right when nothing but its start was pressed', () => {
    expect(first(after(wallTool, drag([100, 100]), [30]))).toMatchObject({ from: [100, 100], to: [400, 100] });
  });

  it('draws a field as wide and high as was typed, or as wide alone', () => {
    expect(first(after(zoneTool, drag([101, 99], [200, 200], [250, 240]), [30, 20]))).toMatchObject({ at: [250, 200], size: [300, 200] }); // prettier-ignore
    expect(first(after(zoneTool, drag([700, 700], [600, 650], [600, 600]), [30]))).toMatchObject({ at: [550, 650], size: [300, 100] }); // prettier-ignore
  });

  it('moves things so far along the drag, or so far to the side and up', () => {
    const things = [block('a', [300, 300])];
    expect(first(after(selectTool, drag([300, 300], [350, 300], [402, 301]), [33.3], things))).toMatchObject({ at: [633, 300] }); // prettier-ignore
    expect(first(after(selectTool, drag([300, 300], [250, 300], [250, 250]), [12, 3], things))).toMatchObject({ at: [180, 270] }); // prettier-ignore
  });

  it('copies a thing exactly so far beside it', () => {
    const one = { ...drag([300, 300], [350, 300], [402, 301]), alt: true };
    const copied = after(selectTool, one, [20], [block('a', [300, 300])]);
    expect(copied.objects).toMatchObject([{ at: [300, 300] }, { at: [500, 300] }]);
  });

  it('sizes a thing by its corner', () => {
    const things = [block('a', [300, 300])];
    const sized = after(selectTool, drag([325, 325], [360, 360], [380, 390]), [12.3, 6], things, { ids: ['a'], robot: false }); // prettier-ignore
    expect(first(sized)).toMatchObject({ size: [123, 60] });
  });

  it('sizes a thing by one of its sides with the first number', () => {
    const things = [block('a', [300, 300])];
    const wider = after(selectTool, drag([325, 300], [360, 310], [380, 310]), [12.3, 6], things, { ids: ['a'], robot: false }); // prettier-ignore
    expect(first(wider)).toMatchObject({ size: [123, 50] });
    const higher = after(selectTool, drag([300, 325], [310, 360], [310, 390]), [9], things, { ids: ['a'], robot: false }); // prettier-ignore
    expect(first(higher)).toMatchObject({ size: [50, 90] });
  });

  it('lengthens a wall at one of its ends', () => {
    const walls = [wall('a', [300, 300], [500, 300])];
    const longer = after(selectTool, drag([502, 301], [550, 300], [560, 300]), [37.7], walls, { ids: ['a'], robot: false }); // prettier-ignore
    expect(first(longer)).toMatchObject({ from: [300, 300], to: [677, 300] });
  });

  it('turns by so many degrees', () => {
    const walls = [wall('a', [300, 300], [500, 300])];
    expect(first(after(rotateTool, drag([480, 300], [450, 400], [440, 380]), [90], walls))).toMatchObject({ from: [400, 200], to: [400, 400] }); // prettier-ignore
  });

  it('sets the robot’s direction, and puts words at a place', () => {
    expect(after(startTool, drag([300, 300], [300, 400], [300, 450]), [37]).robot).toMatchObject({ heading: 37 });
    expect(first(after(labelTool, drag([300, 300], [400, 400]), [12, 34]))).toMatchObject({ at: [120, 340] });
  });
});
