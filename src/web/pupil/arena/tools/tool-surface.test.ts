import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { usualToolOptions as usualOptions } from '#editor/tools/tool-options';
import { nothingSelected, type Selection, type Tool, type ToolContext } from '#editor/tools/tool';
import { wallTool } from '#editor/tools/wall-tool';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type Wall } from '#scene/scene';
import { ghostObjects } from './ghost';
import type { SurfacePress } from './gesture';
import { ToolSurface } from './tool-surface';

/** A view of 1 px per mm: the arena of 1200 × 900 mm fills the canvas, whose y axis points down. */
const px = (x: number, y: number): Vec => ({ x, y: 900 - y });
const rounded = ({ x, y }: Vec) => [Math.round(x), Math.round(y)] as const;

/** Draws a wall from the first to the last place of a drag: the simplest tool there is. */
const lineTool: Tool = {
  id: 'wall',
  cursor: 'crosshair',
  edit({ path }) {
    const [from, to] = [path[0]!, path.at(-1)!];
    if (path.length < 2) return null;
    return { type: 'add', objects: [{ type: 'wall', id: 'w', from: rounded(from), to: rounded(to), thickness: 10 }] };
  },
  marks: ({ path }, _context, isDown) => [{ type: isDown ? 'measure' : 'snap', at: path[0]!, from: path[0]!, to: path.at(-1)! }], // prettier-ignore
  select: (_drag, _context, after) => ({ ids: after.objects.map(({ id }) => id), robot: false }),
};
/** Counts the places of its line, which is shown as ink while it is drawn. */
const inkTool: Tool = { ...lineTool, ink: () => ({ width: 20, color: 'black' }) };

function surfaceOf(tool: Tool, scene = defaultScene()) {
  const done: (SceneEdit | Selection)[] = [];
  const picture: string[] = [];
  let asked = 0;
  const context: ToolContext = { scene, selection: nothingSelected, options: usualOptions, footprint: [] };
  const surface = new ToolSurface({
    view: () => ({ pxPerMm: 1, leftPx: 0, bottomPx: 900 }),
    arena: () => [1200, 900],
    tool: () => ({ ...tool, edit: (...drag) => ((asked += 1), tool.edit(...drag)) }),
    context: () => context,
    isFree: () => false,
    commit: (edit) => done.push(edit),
    select: (selection) => done.push(selection),
    open: ({ part, id }) => void picture.push(`open ${part} ${id}`),
    pan: (by) => picture.push(`pan ${String(by.x)} ${String(by.y)}`),
    zoom: (factor) => picture.push(`zoom ${factor.toFixed(2)}`),
    done: () => undefined,
    changed: () => undefined,
  });
  const keys = { free: false, adds: false };
  return {
    surface,
    done,
    picture,
    asked: () => asked,
    down: (at: Vec, more: Partial<SurfacePress> = {}, nowMs = 0) =>
      surface.pointerDown({ id: 1, at, kind: 'mouse', pans: false, ...keys, ...more }, nowMs),
    move: (at: Vec, id = 1) => surface.pointerMove(id, [at], keys),
    up: (id = 1, nowMs = 0) => surface.pointerUp(id, nowMs),
  };
}

const wall = (from: Wall['from'], to: Wall['to']): SceneEdit => ({
  type: 'add',
  objects: [{ type: 'wall', id: 'w', from, to, thickness: 10 }],
});

describe('a tool in the arena', () => {
  it('turns a drag into one edit, done when the button goes up', () => {
    const { surface, done, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100));
    move(px(150, 100));
    move(px(300, 100));
    expect(done).toEqual([]);
    expect(surface.picture().edit).toEqual(wall([100, 100], [300, 100]));
    up();
    expect(done).toEqual([wall([100, 100], [300, 100])]);
    expect(surface.picture().edit).toBeNull();
  });

  it('is asked once per picture, however often the pointer moved', () => {
    const { surface, asked, down, move } = surfaceOf(lineTool);
    down(px(100, 100));
    for (let x = 101; x < 200; x += 1) move(px(x, 100));
    surface.picture();
    surface.picture();
    expect(asked()).toBe(1);
  });

  it('is not asked for an edit before the end of a line drawn freely: its ink is shown', () => {
    const { surface, asked, done, down, move, up } = surfaceOf(inkTool);
    down(px(100, 100));
    move(px(200, 100));
    expect(surface.picture()).toMatchObject({ edit: null, ink: { width: 20, path: [{ x: 100 }, { x: 200 }] } });
    expect(asked()).toBe(0);
    up();
    expect(done).toHaveLength(1);
  });

  it('is not asked before the end of erasing among 5,000 points either: the way of the eraser is shown', () => {
    const points = Array.from({ length: 5000 }, (_, i) => [i % 1000, 100] as const);
    const many = { ...defaultScene(), objects: [{ type: 'stroke' as const, id: 's', points, width: 20, color: 'black' as const }] }; // prettier-ignore
    const eraser = { ...lineTool, id: 'eraser' as const };
    const { surface, asked, down } = surfaceOf(eraser, many);
    down(px(100, 100));
    expect(surface.picture().ink).toMatchObject({ width: usualOptions.eraserWidth, color: 'white' });
    expect(asked()).toBe(0);
    const few = surfaceOf(eraser);
    few.down(px(100, 100));
    expect(few.surface.picture().ink).toBeNull();
  });

  it('gets every place that the pointer came by, also several of one event', () => {
    const { surface, down } = surfaceOf(inkTool);
    down(px(100, 100));
    surface.pointerMove(1, [px(110, 100), px(110, 100), px(120, 100)], { free: false });
    expect(surface.picture().ink?.path.map(({ x }) => x)).toEqual([100, 110, 120]);
  });

  it('tells what a line comes to so far, while its ink is drawn, and shows it no differently', () => {
    const { surface, down, move, up, done } = surfaceOf(inkTool);
    expect(surface.editSoFar()).toBeNull();
    down(px(100, 100));
    move(px(200, 100));
    expect(surface.editSoFar()).toEqual(wall([100, 100], [200, 100]));
    expect(surface.picture()).toMatchObject({ edit: null, after: null });
    expect(done).toEqual([]);
    up();
    expect(surface.editSoFar()).toBeNull();
  });

  it('drops the drag at Escape, and what comes after it', () => {
    const { surface, done, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100));
    move(px(300, 100));
    expect(surface.cancel()).toBe(true);
    move(px(400, 100));
    up();
    expect(done).toEqual([]);
  });

  it('selects after a tap that changes nothing', () => {
    const { done, down, up } = surfaceOf(lineTool);
    down(px(100, 100));
    up();
    expect(done).toEqual([{ ids: [], robot: false }]);
  });

  it('keeps what was measured in sight until the next drag', () => {
    const { surface, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100));
    move(px(300, 100));
    up();
    surface.pointerLeave();
    expect(surface.picture().marks).toMatchObject([{ type: 'measure', from: { x: 100 }, to: { x: 300 } }]);
    down(px(500, 500), { pans: true });
    expect(surface.picture().marks).toEqual([]);
  });

  it('show what a tool has at rest to those who never hover: before the first touch and after it', () => {
    const gridTool: Tool = { ...lineTool, marksAtRest: () => [{ type: 'grid', cellMm: 150, edge: null }] };
    const { surface, down, up } = surfaceOf(gridTool);
    expect(surface.picture().marks).toEqual([{ type: 'grid', cellMm: 150, edge: null }]);
    down(px(100, 100), { kind: 'touch' });
    expect(surface.picture().marks).toMatchObject([{ type: 'measure' }]);
    up();
    expect(surface.picture().marks).toContainEqual({ type: 'grid', cellMm: 150, edge: null });
  });
});

describe('two fingers on the arena', () => {
  it('drop what the first one had begun, and move and zoom the picture', () => {
    const { done, picture, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100), { kind: 'touch' });
    move(px(200, 100));
    down(px(300, 100), { id: 2, kind: 'touch' });
    move(px(400, 100), 2);
    expect(picture).toEqual(['pan 50 0', 'zoom 2.00']);
    up(2);
    move(px(250, 100)); // the finger that is still down
    up();
    expect(done).toEqual([]);
    expect(picture.at(-1)).toBe('pan 50 0');
  });

  it('leave the next single finger to the tool', () => {
    const { done, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100), { kind: 'touch' });
    down(px(300, 100), { id: 2, kind: 'touch' });
    up(1);
    up(2);
    down(px(100, 100), { id: 3, kind: 'touch' });
    move(px(200, 100), 3);
    up(3);
    expect(done).toHaveLength(1);
  });
});

describe('a pen on the arena', () => {
  it('draws while the hand rests on the screen', () => {
    const { done, picture, down, move, up } = surfaceOf(lineTool);
    down(px(500, 100), { id: 7, kind: 'touch' }); // the palm touches first
    down(px(100, 100), { id: 1, kind: 'pen' });
    down(px(520, 90), { id: 8, kind: 'touch' });
    move(px(510, 100), 7);
    move(px(200, 100));
    up(1, 1000);
    down(px(530, 90), { id: 9, kind: 'touch' }, 1200); // lifted 0.2 s after the pen
    up(9, 1300);
    expect(done).toEqual([wall([100, 100], [200, 100])]);
    expect(picture).toEqual([]);
  });
});

describe('another button or the space bar', () => {
  it('moves the picture whatever the tool is', () => {
    const { done, picture, down, move, up } = surfaceOf(lineTool);
    down(px(100, 100), { pans: true });
    move(px(130, 90));
    up();
    expect([done, picture]).toEqual([[], ['pan 30 10']]);
  });
});

describe('the crosshair of the keyboard', () => {
  const middle = { x: 604, y: 447 };

  it('begins at a whole cm in the middle and goes 10 mm per arrow', () => {
    const { surface } = surfaceOf(lineTool);
    expect(surface.moveCrosshair({ x: 10, y: 0 }, middle, false)).toEqual({ x: 600, y: 450 });
    expect(surface.moveCrosshair({ x: 10, y: 0 }, middle, false)).toEqual({ x: 610, y: 450 });
  });

  it('draws between two presses of Enter', () => {
    const { surface, done } = surfaceOf(lineTool);
    expect(surface.pressKey(middle)).toBe(true);
    for (let i = 0; i < 5; i += 1) surface.moveCrosshair({ x: 0, y: 10 }, middle, false);
    expect(surface.picture()).toMatchObject({ crosshair: { at: { x: 600, y: 500 }, isDown: true } });
    expect(surface.pressKey(middle)).toBe(false);
    expect(done).toEqual([wall([600, 450], [600, 500])]);
  });

  it('stays inside the arena and vanishes when the pointer moves', () => {
    const { surface, move } = surfaceOf(lineTool);
    surface.moveCrosshair({ x: 0, y: 0 }, middle, false);
    expect(surface.moveCrosshair({ x: -5000, y: 10 }, middle, false)).toEqual({ x: 0, y: 460 });
    move(px(10, 10));
    expect(surface.picture().crosshair).toBeNull();
  });

  it('keeps what it draws when the keyboard goes elsewhere or another tool is chosen', () => {
    for (const leave of ['blur', 'reset'] as const) {
      const { surface, done } = surfaceOf(lineTool);
      surface.pressKey(middle);
      surface.moveCrosshair({ x: 0, y: 10 }, middle, false);
      surface[leave]();
      expect([done, surface.isBusy]).toEqual([[wall([600, 450], [600, 460])], false]);
    }
  });

  it('drops what it draws with Escape alone', () => {
    const { surface, done } = surfaceOf(lineTool);
    surface.pressKey(middle);
    surface.moveCrosshair({ x: 0, y: 10 }, middle, false);
    expect(surface.cancel()).toBe(true);
    surface.blur();
    expect(done).toEqual([]);
  });

  it('puts a block or a zone down with one press, and drags it with Shift', () => {
    const { surface, done } = surfaceOf({
      ...lineTool,
      putsDown: true,
      edit: ({ path }) => wall([path[0]!.x, path[0]!.y], [path.at(-1)!.x, path.at(-1)!.y]),
    });
    expect(surface.pressKey(middle)).toBe(false);
    expect(done).toEqual([wall([600, 450], [600, 450])]);
    expect(surface.pressKey(middle, true)).toBe(true);
    surface.moveCrosshair({ x: 10, y: 0 }, middle, false);
    expect(surface.pressKey(middle)).toBe(false);
    expect(done.at(-1)).toEqual(wall([600, 450], [610, 450]));
  });
});

describe('a double tap', () => {
  const openTool: Tool = { ...lineTool, opens: ({ path }) => ({ part: 'words', id: `at ${String(path[0]!.x)}` }) };
  const tapAt = ({ down, up }: ReturnType<typeof surfaceOf>, x: number, atMs: number) => {
    down(px(x, 100), {}, atMs);
    up(1, atMs + 80);
  };

  it('opens what is inside a thing, on the same place and within half a second', () => {
    const over = surfaceOf(openTool);
    tapAt(over, 100, 1000);
    expect(over.done).toHaveLength(1);
    tapAt(over, 103, 1300);
    expect([over.picture, over.done]).toEqual([['open words at 103'], [over.done[0]]]);
    tapAt(over, 103, 1500); // a third one starts over
    expect(over.picture).toHaveLength(1);
  });

  it('is two taps where the second comes late, or elsewhere, or is a drag', () => {
    const over = surfaceOf(openTool);
    tapAt(over, 100, 1000);
    tapAt(over, 100, 1700);
    tapAt(over, 200, 1900);
    over.down(px(200, 100), {}, 2100);
    over.move(px(300, 100));
    over.up(1, 2200);
    expect([over.picture, over.done.length]).toEqual([[], 4]);
  });
});

describe('what an edit would change', () => {
  it('is shown apart from the rest of the course: the new object, without the old one', () => {
    const a: Wall = { type: 'wall', id: 'a', from: [0, 0], to: [100, 0], thickness: 10 };
    const b: Wall = { ...a, id: 'b' };
    const scene = { ...defaultScene(), objects: [a, b] };
    const moved = { ...b, to: [50, 50] as const };
    const after = applyEdit(scene, { type: 'replace', changes: [{ id: 'b', by: [moved] }] });
    expect(ghostObjects(scene, after)).toEqual({ shown: [moved], hidden: new Set(['b']) });
    expect(ghostObjects(scene, null).hidden.size).toBe(0);
  });
});

describe('a line that is drawn corner by corner', () => {
  const chain = () => surfaceOf(wallTool);
  const click = ({ down, up }: ReturnType<typeof chain>, at: Vec, press: Partial<SurfacePress> = {}) => {
    down(at, press);
    up(press.id ?? 1);
  };
  const walls = (done: readonly unknown[]) =>
    (done as SceneEdit[]).map((edit) => (edit.type === 'add' ? edit.objects.length : -1));

  it('is one edit when its last corner is clicked again', () => {
    const desk = chain();
    for (const at of [px(100, 100), px(400, 100), px(400, 300)]) click(desk, at);
    expect(desk.done).toEqual([]);
    expect(desk.surface.isChaining).toBe(true);
    click(desk, px(402, 302));
    expect(walls(desk.done)).toEqual([2]);
    expect(desk.surface.isBusy).toBe(false);
  });

  it('shows what the next click would add while the mouse moves with nothing pressed', () => {
    const desk = chain();
    click(desk, px(100, 100));
    desk.move(px(400, 100));
    expect(desk.surface.picture().after?.objects).toMatchObject([{ from: [100, 100], to: [400, 100] }]);
    desk.surface.pointerLeave();
    expect(desk.surface.picture().edit).toBeNull();
  });

  it('is closed by a tap of a finger on its first corner', () => {
    const desk = chain();
    for (const at of [px(100, 100), px(400, 100), px(400, 300), px(110, 110)]) click(desk, at, { kind: 'touch' });
    expect(walls(desk.done)).toEqual([3]);
  });

  it('is drawn, ended and taken back with the keyboard', () => {
    const desk = chain();
    const middle = { x: 100, y: 100 };
    desk.surface.pressKey(middle);
    desk.surface.pressKey(middle);
    expect(desk.surface.isChaining).toBe(true);
    desk.surface.moveCrosshair({ x: 200, y: 0 }, middle, false);
    desk.surface.pressKey(middle);
    desk.surface.moveCrosshair({ x: 0, y: 150 }, middle, false);
    desk.surface.pressKey(middle);
    desk.surface.takeCornerBack();
    desk.surface.endChain();
    expect(walls(desk.done)).toEqual([1]);
  });

  it('stays while two fingers move the picture, and goes with Escape', () => {
    const desk = chain();
    click(desk, px(100, 100), { kind: 'touch' });
    desk.down(px(300, 300), { kind: 'touch' });
    desk.down(px(500, 300), { kind: 'touch', id: 2 });
    desk.move(px(520, 320), 2);
    desk.up(1);
    desk.up(2);
    expect(desk.surface.isChaining).toBe(true);
    click(desk, px(400, 100), { kind: 'touch' });
    expect(desk.surface.picture().after?.objects).toHaveLength(1);
    expect(desk.surface.cancel()).toBe(true);
    expect(desk.done).toEqual([]);
  });
});
