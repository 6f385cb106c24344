// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { computed, nextTick, shallowRef } from 'vue';

import type { Vec } from '#core/geometry';
import type { SceneObject } from '#scene/scene';

import { editingPage, samples } from '../../../app/testing/editing';
import '../../../app/testing/mount-on';
import type { ArenaTool } from '../../../course/editor/state/course-editor-model';
import { lightPalette } from '../model/palette';
import { RecordingCanvas, recordCanvases } from '../testing/recording-canvas';
import type { ArenaView } from '../view/use-arena-view';
import { createArenaTools } from './arena-tools';
import { readingPlace } from './draw-guides';
import type { HeldParts } from './ghost';

const palette = lightPalette;

/** The tools over an arena of 1200 × 900 mm at 1 px per mm: the place of a pointer is that of the course, y upward. */
async function toolsOver(tool: ArenaTool, objects: readonly SceneObject[] = [], robot = true) {
  const page = await editingPage(objects);
  const said: string[] = [];
  const moved: Vec[] = [];
  const boxes: (readonly number[])[] = [];
  let ghost: HeldParts | null = null;
  const picture: ArenaView = {
    view: shallowRef({ pxPerMm: 1, leftPx: 0, bottomPx: 900 }),
    canvas: shallowRef({ widthPx: 1200, heightPx: 900 }),
    ratio: computed(() => 1),
    percent: computed(() => 100),
    zoomBy: () => undefined,
    panBy: (by) => void moved.push(by),
    fit: () => undefined,
    showAll: () => undefined,
    showBox: ({ minX, minY, maxX, maxY }) => void boxes.push([minX, minY, maxX, maxY]),
    showTrueSize: () => undefined,
    showNear: () => undefined,
    showPlace: () => undefined,
    follow: () => false,
  };
  const square = [{ x: -50, y: -50 }, { x: 50, y: -50 }, { x: 50, y: 50 }, { x: -50, y: 50 }]; // prettier-ignore
  const tools = createArenaTools({
    editor: page.editor,
    picture,
    course: page.scene,
    footprint: () => (robot ? [square] : []),
    palette: () => palette,
    inkCanvas: () => null,
    redraw: () => undefined,
    showGhost: (now) => (ghost = now),
    say: (words) => void said.push(words),
  });
  page.editor.choose(tool);
  tools.toolChanged();
  const look = (): RecordingCanvas => {
    const canvas = new RecordingCanvas();
    tools.place();
    tools.paint(canvas.context);
    return canvas;
  };
  /** Pointers have a time of their own, so that none is a second tap. */
  let atMs = 0;
  const event = (x: number, y: number, more: object = {}) => ({
    ...{
      pointerId: 1,
      pointerType: 'mouse',
      button: 0,
      shiftKey: false,
      altKey: false,
      ctrlKey: false,
      metaKey: false,
    },
    ...{ timeStamp: (atMs += 1000), offsetX: x, offsetY: 900 - y, clientX: x, clientY: 900 - y, currentTarget: null },
    ...more,
  });
  const down = (x: number, y: number, more?: object) => tools.pointerdown(event(x, y, more));
  const move = (x: number, y: number, more?: object) => tools.pointermove(event(x, y, more));
  const up = (x = 0, y = 0) => {
    look(); // a picture is drawn between the last movement and the end
    tools.pointerup(event(x, y));
  };
  const drag = (...[first, ...others]: readonly (readonly [number, number])[]) => {
    down(...first!);
    for (const at of others) move(...at);
    up(...(others.at(-1) ?? first!));
  };
  const tap = (x: number, y: number, more?: object) => {
    down(x, y, more);
    up(x, y);
  };
  const key = (name: string, more: KeyboardEventInit = {}) =>
    tools.keyDown(new KeyboardEvent('keydown', { key: name, ...more }));
  const letGo = (name: string) => tools.keyUp(new KeyboardEvent('keyup', { key: name }));
  const only = () => page.scene().objects[0]!;
  return { ...page, tools, look, down, move, up, drag, tap, key, letGo, said, moved, boxes, only, ghost: () => ghost };
}

beforeEach(recordCanvases);
afterEach(() => void vi.useRealTimers());

describe('drawing in the arena', () => {
  it('makes a straight line of a drag, as wide and in the colour that is set', async () => {
    const { editor, drag, only, steps } = await toolsOver('pen');
    editor.setOptions({ penShape: 'straight', penWidth: 30, penColor: 'red' });
    drag([100, 100], [200, 100], [400, 100]);
    expect(only()).toMatchObject({ type: 'stroke', width: 30, color: 'red' });
    expect((only() as { points: unknown }).points).toEqual([[100, 100], [400, 100]]); // prettier-ignore
    expect(steps()).toBe(1);
  });

  it('makes a dot of a tap with the pen', async () => {
    const { tap, only } = await toolsOver('pen');
    tap(300, 300);
    expect(only().type).toBe('stroke');
  });

  it('shows the tip of the pen where the mouse is, in its colour', async () => {
    const { move, look, editor } = await toolsOver('pen');
    editor.setOptions({ penColor: 'blue', penWidth: 40 });
    move(500, 400);
    const [tip] = look().in(palette.strokes.blue);
    expect([tip?.left, tip?.right, tip?.top, tip?.bottom]).toEqual([480, 520, 480, 520]);
  });

  it('erases things that the eraser goes over, which one undo brings back, and spares them where that is set', async () => {
    const { editor, drag, ids } = await toolsOver('eraser', [samples.stroke, samples.wall]);
    drag([200, 90], [200, 110]);
    expect(ids()).toEqual(['line']);
    editor.undo();
    expect(ids()).toEqual(['line', 'wall']);
    editor.setOptions({ eraser: 'lines' });
    drag([200, 90], [200, 110]);
    expect(ids()).toEqual(['line', 'wall']);
  });

  it('outlines in red what a click would take, before it is taken', async () => {
    const { move, look, ids } = await toolsOver('eraser', [samples.wall]);
    expect(look().in(palette.forbidden)).toEqual([]);
    move(200, 100);
    expect(look().in(palette.forbidden)).toHaveLength(1);
    expect(ids()).toEqual(['wall']);
  });

  it('cuts a line in two where a piece is erased out of its middle', async () => {
    const { drag, scene } = await toolsOver('eraser', [samples.stroke]);
    drag([200, 850], [200, 750]);
    const strokes = scene().objects.filter(({ type }) => type === 'stroke');
    expect(strokes).toHaveLength(2);
  });

  it('shows a wall while it is drawn, which is in the course only when the button goes up', async () => {
    const { down, move, up, look, ids, only, editor } = await toolsOver('wall');
    down(100, 500);
    move(400, 500);
    const wall = look().in(palette.wall);
    expect([Math.min(...wall.map(({ left }) => left)), Math.max(...wall.map(({ right }) => right))]).toEqual([100, 400]); // prettier-ignore
    expect([ids(), editor.drag.value?.type]).toEqual([[], 'add']);
    up(400, 500);
    expect(only()).toMatchObject({ type: 'wall', from: [100, 500], to: [400, 500] });
    expect(editor.drag.value).toBeNull();
  });

  it.each([
    ['block', 'movable'],
    ['fixed-block', 'fixed'],
    ['spikes', 'spikes'],
  ] as const)('puts a %s where the arena is tapped', async (block, color) => {
    const { editor, tap, down, look, only } = await toolsOver('block');
    editor.setOptions({ block, blockSize: [100, 50] });
    down(300, 300);
    expect(look().in(palette[color]).length).toBeGreaterThan(0);
    tap(300, 300);
    expect(only()).toMatchObject({ type: block, at: [300, 300], size: [100, 50] });
  });

  it('leads a moving block from where the drag begins to where it ends', async () => {
    const { editor, drag, only } = await toolsOver('block');
    editor.setOptions({ block: 'mover', moverSpeed: 200, moverSpiked: true });
    drag([200, 200], [300, 200], [500, 200]);
    expect(only()).toMatchObject({ type: 'mover', at: [200, 200], to: [500, 200], speed: 200, spiked: true });
  });

  it('numbers checkpoints in the order in which they are put', async () => {
    const { editor, tap, scene } = await toolsOver('zone');
    editor.setOptions({ zone: 'checkpoint' });
    tap(200, 200);
    tap(800, 200);
    tap(800, 700);
    expect(scene().objects.map((one) => ('number' in one ? one.number : null))).toEqual([1, 2, 3]);
  });

  it('writes the words that are set, and nothing where there are none', async () => {
    const { editor, tap, ids, only } = await toolsOver('label');
    tap(300, 300);
    expect(ids()).toEqual([]);
    editor.setOptions({ labelText: ' Garage ', labelHeight: 60 });
    tap(300, 300);
    expect(only()).toMatchObject({ type: 'label', text: 'Garage', height: 60 });
  });

  it('draws an edge of a maze at a tap, and takes it away at the next', async () => {
    const { tap, only, ids } = await toolsOver('maze');
    tap(225, 150);
    // Half the thickness of 10 mm longer at both ends: edges meet in full corners.
    expect(only()).toMatchObject({ type: 'wall', from: [145, 150], to: [305, 150] });
    tap(225, 150);
    expect(ids()).toEqual([]);
  });

  it('measures without changing the course: the head of the arena hears of it', async () => {
    const { down, move, look, editor, steps } = await toolsOver('ruler');
    down(100, 100);
    move(400, 500);
    const canvas = look();
    expect(canvas.words.join()).toContain('50.0 cm · 53°');
    expect(editor.measure.value).toMatchObject({ from: { x: 100, y: 100 }, to: { x: 400, y: 500 } });
    expect(steps()).toBe(0);
  });

  it('puts the start where the arena is tapped, and shows its outline dashed', async () => {
    const { down, up, look, scene } = await toolsOver('start');
    down(300, 300);
    expect(look().painted.some(({ by, dashed }) => by === 'stroke' && dashed)).toBe(true);
    up(300, 300);
    expect(scene().robot.at).toEqual([300, 300]);
  });

  it('keeps the start inside the arena', async () => {
    const { tap, scene } = await toolsOver('start');
    tap(1195, 5);
    const [x, y] = scene().robot.at;
    expect([x <= 1150, y >= 50]).toEqual([true, true]);
  });

  it('begins nothing that the arena lost the pointer over', async () => {
    const { tools, down, move, steps, ids } = await toolsOver('wall');
    down(100, 100);
    move(300, 100);
    tools.pointercancel({ pointerId: 1 } as PointerEvent);
    expect([ids(), steps()]).toEqual([[], 0]);
  });

  it('drops what was begun when the course changes beneath it', async () => {
    const { tools, down, move, up, ids } = await toolsOver('wall');
    down(100, 100);
    move(300, 100);
    tools.courseChanged();
    up(300, 100);
    expect(ids()).toEqual([]);
  });

  it('moves the picture with the other button, and with the space bar held', async () => {
    const { down, move, up, moved, ids, key, letGo, tools } = await toolsOver('wall');
    down(100, 100, { button: 1 });
    move(150, 100);
    expect([moved.length > 0, tools.cursor()]).toEqual([true, 'grabbing']);
    up(150, 100);
    key(' ');
    down(100, 100);
    move(160, 100);
    up(160, 100);
    letGo(' ');
    expect(ids()).toEqual([]);
    expect(moved.reduce((sum, { x }) => sum + x, 0)).toBe(110);
  });

  it('shows the sign of the tool beside the finger that hides its work', async () => {
    const { down, look } = await toolsOver('wall');
    down(300, 300, { pointerType: 'touch' });
    const [disc] = look().in(palette.handGround);
    expect(disc!.bottom).toBeLessThan(600 - 40); // the finger is at 600 px
  });
});

describe('selecting in the arena', () => {
  const two = [samples.block, samples.wall];

  it('takes what is tapped, frames it and names it; a tap beside it lets go', async () => {
    const { tap, editor, look } = await toolsOver('select', two);
    tap(400, 200);
    expect(editor.selection.value.ids).toEqual(['block']);
    expect(editor.said.value).toBe('Gewählt: Block 1, 5 × 5 cm bei 40 | 20 cm');
    const frames = look().in(palette.hand);
    expect(frames.some(({ left, right }) => left === 371 && right === 429)).toBe(true); // 4 px around 50 mm
    tap(700, 800);
    expect(editor.selection.value.ids).toEqual([]);
    expect(look().in(palette.hand)).toEqual([]);
  });

  it.each(['shiftKey', 'ctrlKey', 'metaKey'])('takes more and less again with %s', async (held) => {
    const { tap, editor } = await toolsOver('select', two);
    tap(400, 200);
    tap(200, 100, { [held]: true });
    expect([...editor.selection.value.ids].sort()).toEqual(['block', 'wall']);
    tap(200, 100, { [held]: true });
    expect(editor.selection.value.ids).toEqual(['block']);
  });

  it('does not snap while Ctrl is held in a drag, which moves nothing else then, and snaps with Shift', async () => {
    const { tap, down, move, up, object } = await toolsOver('select', two);
    const wall = object('wall', 'wall');
    tap(200, 100);
    down(400, 200);
    move(453, 200, { ctrlKey: true });
    up(453, 200);
    expect(object('block', 'block')).toMatchObject({ at: [453, 200] });
    expect(object('wall', 'wall')).toEqual(wall);
    down(453, 200);
    move(502, 200, { shiftKey: true });
    up(502, 200);
    expect(object('block', 'block')).toMatchObject({ at: [500, 200] });
  });

  it('takes all in a frame that is drawn around them', async () => {
    const { tap, drag, editor } = await toolsOver('select', two);
    tap(400, 200);
    drag([50, 50], [300, 200], [450, 300]);
    expect([...editor.selection.value.ids].sort()).toEqual(['block', 'wall']);
  });

  it('moves what it drags, and hides the original meanwhile', async () => {
    const { down, move, up, object, ghost, editor, steps } = await toolsOver('select', two);
    editor.free.value = true;
    down(400, 200);
    move(450, 250);
    move(500, 300);
    up(500, 300);
    expect(ghost()?.hidden.has('block')).toBe(true);
    expect([object('block', 'block').at, steps()]).toEqual([[500, 300], 1]);
    expect(object('wall', 'wall').from).toEqual([100, 100]);
  });

  it('moves the whole group when one of it is dragged', async () => {
    const { drag, editor, object } = await toolsOver('select', two);
    editor.free.value = true;
    editor.select({ ids: ['block', 'wall'], robot: false });
    drag([400, 200], [420, 240], [440, 260]);
    expect([object('block', 'block').at, object('wall', 'wall').from]).toEqual([[440, 260], [140, 160]]); // prettier-ignore
  });

  it('lets the start be moved like anything else', async () => {
    const { drag, editor, scene } = await toolsOver('select', []);
    editor.free.value = true;
    drag([600, 450], [650, 450], [700, 450]);
    expect(scene().robot.at).toEqual([700, 450]);
  });

  it('turns what is tapped by 45° with the tool for it', async () => {
    const { tap, object, steps } = await toolsOver('rotate', two);
    tap(400, 200);
    expect([object('block', 'block').angle, steps()]).toEqual([45, 1]);
  });

  it('takes back every drag, in reverse order', async () => {
    const { drag, editor, object } = await toolsOver('select', two);
    editor.free.value = true;
    drag([400, 200], [420, 200], [500, 200]);
    drag([500, 200], [500, 250], [500, 300]);
    editor.undo();
    expect(object('block', 'block').at).toEqual([500, 200]);
    editor.undo();
    expect(object('block', 'block').at).toEqual([400, 200]);
  });
});

describe('the keyboard in the arena', () => {
  it('draws a wall: Enter begins, arrows lead 1 cm each, Enter ends', async () => {
    const { key, only, said, look } = await toolsOver('wall');
    key('ArrowRight'); // the first press shows the crosshair in the middle
    expect(key('ArrowRight')).toBe(true);
    key('Enter');
    expect(said).toEqual(['Ansetzen bei 61 | 45 cm']);
    for (let times = 0; times < 10; times += 1) key('ArrowUp');
    look();
    key('Enter');
    expect(only()).toMatchObject({ type: 'wall', from: [610, 450], to: [610, 550] });
  });

  it('leads by 1 mm with Shift', async () => {
    const { key, said } = await toolsOver('wall');
    key('ArrowRight');
    key('ArrowRight', { shiftKey: true });
    key('Enter');
    expect(said).toEqual(['Ansetzen bei 60.1 | 45 cm']);
  });

  it('puts a block down with one Enter, and says so in sight what is under way', async () => {
    const { key, ids, look, steps } = await toolsOver('block');
    key('ArrowRight');
    key('Enter');
    expect([ids().length, steps()]).toEqual([1, 1]);
    for (let times = 0; times < 20; times += 1) key('ArrowUp');
    const before = look().painted.length;
    key('Enter', { shiftKey: true });
    key('ArrowUp');
    expect(look().painted.length).toBeGreaterThan(before);
    key('Enter');
    expect(ids().length).toBe(2);
  });

  it('keeps a line that was begun when another tool is chosen', async () => {
    const { key, only, editor, tools } = await toolsOver('wall');
    key('Enter');
    for (let times = 0; times < 10; times += 1) key('ArrowUp');
    editor.choose('pen');
    tools.toolChanged();
    expect(only()).toMatchObject({ type: 'wall', from: [600, 450], to: [600, 550] });
  });

  it('shows what is selected large with Shift+2, on every keyboard', async () => {
    const { editor, key, boxes } = await toolsOver('select', [samples.block]);
    expect(key('"', { code: 'Digit2', shiftKey: true })).toBe(false);
    editor.select({ ids: ['block'], robot: false });
    expect(key('"', { code: 'Digit2', shiftKey: true })).toBe(true);
    expect(boxes).toEqual([[375, 175, 425, 225]]);
  });

  it('drops with Escape what was begun, and says so', async () => {
    const { key, said, ids } = await toolsOver('wall');
    key('Enter');
    key('ArrowUp');
    expect(key('Escape')).toBe(true);
    expect(said.at(-1)).toBe('Verworfen');
    key('ArrowUp');
    expect(ids()).toEqual([]);
    expect(key('Escape')).toBe(false); // nothing more to drop: the key is the page's
  });

  it('says where the crosshair is once it rests', async () => {
    vi.useFakeTimers();
    const { key, said } = await toolsOver('wall');
    for (let times = 0; times < 6; times += 1) key('ArrowLeft');
    expect(said).toEqual([]);
    vi.advanceTimersByTime(400);
    expect(said).toEqual(['55 | 45 cm']);
  });

  it('moves what is selected; what the arrows did until they are let go is one step', async () => {
    const { editor, key, letGo, object, steps } = await toolsOver('select', [samples.block]);
    editor.select({ ids: ['block'], robot: false });
    for (let times = 0; times < 3; times += 1) key('ArrowRight');
    key('ArrowUp', { shiftKey: true });
    expect(steps()).toBe(0);
    letGo('ArrowUp');
    expect([object('block', 'block').at, steps()]).toEqual([[430, 201], 1]);
  });

  it('turns with Q and E, deletes with Delete and lets go with Escape', async () => {
    const { editor, key, object, ids } = await toolsOver('select', [samples.block]);
    editor.select({ ids: ['block'], robot: false });
    key('q');
    expect(object('block', 'block').angle).toBe(45);
    key('e');
    key('e');
    expect(object('block', 'block').angle).toBe(315);
    key('Escape');
    expect(editor.selection.value.ids).toEqual([]);
    expect(key('Delete')).toBe(false);
    editor.select({ ids: ['block'], robot: false });
    key('Delete');
    expect(ids()).toEqual([]);
  });

  it('leaves keys with Alt to the browser', async () => {
    const { key } = await toolsOver('wall');
    expect([key('ArrowLeft', { altKey: true }), key('Escape', { altKey: true })]).toEqual([false, false]);
  });

  it('hears how to use it when the arena gets the keyboard', async () => {
    const { tools, said, editor } = await toolsOver('select', [samples.block]);
    tools.focus();
    expect(said.at(-1)).toContain('Pfeiltasten bewegen das Fadenkreuz');
    editor.select({ ids: ['block'], robot: false });
    tools.focus();
    expect(said.at(-1)).toContain('Pfeiltasten verschieben die Auswahl');
  });

  it('does what the arrows have moved when the keyboard leaves', async () => {
    const { tools, editor, key, object } = await toolsOver('select', [samples.block]);
    editor.select({ ids: ['block'], robot: false });
    key('ArrowLeft');
    tools.blur();
    expect(object('block', 'block').at).toEqual([390, 200]);
  });

  it('moves the picture along when the crosshair comes to its edge', async () => {
    const { key, moved } = await toolsOver('wall');
    for (let times = 0; times < 58; times += 1) key('ArrowRight');
    expect(moved.length).toBeGreaterThan(0);
    expect(moved.every(({ x, y }) => x < 0 && y === 0)).toBe(true);
  });

  it('shows nothing of a tool once the hand is chosen', async () => {
    const { editor, tools, move, look } = await toolsOver('pen');
    move(500, 400);
    editor.choose('hand');
    await nextTick();
    expect([tools.place(), tools.cursor(), look().painted]).toEqual([null, 'default', []]);
  });
});

describe('the menu for what is in the arena', () => {
  it('opens by the right button on a thing, which is selected then, whatever the tool is', async () => {
    const { editor, tap } = await toolsOver('pen', [samples.wall, samples.block]);
    tap(200, 100, { button: 2 });
    expect([editor.tool.value, editor.selection.value.ids]).toEqual(['select', ['wall']]);
    expect(editor.menu.value).toMatchObject({ on: 'things', xPx: 200, yPx: 800, atMm: { x: 200, y: 100 } });
  });

  it('keeps what is selected where it opens on a part of it, and on the floor', async () => {
    const { editor, tap } = await toolsOver('select', [samples.wall, samples.block]);
    editor.select({ ids: ['wall', 'block'], robot: false });
    tap(200, 100, { button: 2 });
    tap(900, 800, { button: 2 });
    expect([editor.selection.value.ids, editor.menu.value?.on]).toEqual([['wall', 'block'], 'floor']);
  });

  it('does not open where the right button moves the picture', async () => {
    const { editor, down, move, up, moved } = await toolsOver('select', [samples.wall]);
    down(200, 100, { button: 2 });
    move(260, 100);
    up(260, 100);
    expect([editor.menu.value, moved.length > 0]).toEqual([null, true]);
  });

  it('opens by a finger that rests for half a second, and the finger does nothing else then', async () => {
    vi.useFakeTimers();
    const { editor, down, move, up, steps } = await toolsOver('select', [samples.wall]);
    const finger = { pointerType: 'touch' };
    down(200, 100, finger);
    move(203, 101, finger);
    vi.advanceTimersByTime(499);
    expect(editor.menu.value).toBeNull();
    vi.advanceTimersByTime(1);
    expect([editor.menu.value?.on, editor.selection.value.ids]).toEqual(['things', ['wall']]);
    move(300, 300, finger);
    up(300, 300);
    expect([steps(), editor.selection.value.ids]).toEqual([0, ['wall']]);
  });

  it('does not open by a finger that moves, or draws', async () => {
    vi.useFakeTimers();
    const { editor, down, move, up } = await toolsOver('select', [samples.wall]);
    down(200, 100, { pointerType: 'touch' });
    move(240, 140, { pointerType: 'touch' });
    vi.advanceTimersByTime(1000);
    up(240, 140);
    editor.choose('pen');
    down(200, 100, { pointerType: 'touch' });
    vi.advanceTimersByTime(1000);
    expect(editor.menu.value).toBeNull();
  });

  it('opens by Shift+F10 and by its key on what is selected, or under the crosshair', async () => {
    const { editor, key } = await toolsOver('select', [samples.wall]);
    expect(key('ContextMenu')).toBe(true);
    expect(editor.menu.value).toMatchObject({ on: 'floor', atMm: { x: 600, y: 450 } });
    editor.select({ ids: ['wall'], robot: false });
    key('F10', { shiftKey: true });
    expect(editor.menu.value?.on).toBe('things');
  });
});

describe('a double click', () => {
  const label: SceneObject = { type: 'label', id: 'label', at: [300, 300], text: 'Start', height: 30, angle: 0 };

  it('changes the words of a label in their place, and takes hold of the points of a line', async () => {
    const { editor, tap } = await toolsOver('select', [label, samples.stroke]);
    tap(300, 300, { timeStamp: 1 });
    tap(300, 300, { timeStamp: 2 });
    expect(editor.words.value).toMatchObject({ id: 'label', xPx: 300, yPx: 600 });
    const [x, y] = samples.stroke.points[0];
    tap(x, y, { timeStamp: 5000 });
    tap(x, y, { timeStamp: 5001 });
    expect([editor.selection.value.ids, editor.tool.value]).toEqual([['line'], 'points']);
  });
});

describe('a drag with Alt', () => {
  it('leaves copies where it ends, selected, as one step', async () => {
    const { editor, down, move, up, ids, object, steps } = await toolsOver('select', [samples.block]);
    const [x, y] = samples.block.at;
    down(x, y);
    move(x + 100, y, { altKey: true });
    up(x + 100, y);
    expect([ids(), steps(), editor.selection.value.ids]).toEqual([['block', 'block-1'], 1, ['block-1']]);
    expect(object('block', 'block-1').at).toEqual([x + 100, y]);
    editor.undo();
    expect(ids()).toEqual(['block']);
  });
});

describe('a full course', () => {
  const full = Array.from({ length: 2000 }, (_, i) => ({ ...samples.wall, id: `w${String(i)}` }));

  it('takes no copy with Ctrl+D, and the editor says why', async () => {
    const { editor, key, scene } = await toolsOver('select', full);
    editor.select({ ids: ['w0'], robot: false });
    expect(key('d', { ctrlKey: true })).toBe(true);
    expect([scene().objects.length, editor.problem.value?.code]).toEqual([2000, 'too-many']);
  });
});

describe('figures beside the pointer', () => {
  it('are a wall’s length and direction while it is drawn, and are told at its end', async () => {
    const { down, move, up, look, said } = await toolsOver('wall');
    down(100, 500);
    move(400, 500);
    expect(look().words.join()).toContain('30.0 cm · 0°');
    up(400, 500);
    expect(said.at(-1)).toBe('Länge 30.0 cm, Richtung 0°');
  });

  it('are above a finger, or beside it where there is no room', () => {
    const canvas = { widthPx: 1200, heightPx: 900 };
    expect(readingPlace({ x: 500, y: 500 }, true, canvas)).toEqual({ x: 500, y: 434 });
    expect(readingPlace({ x: 500, y: 60 }, true, canvas)).toEqual({ x: 350, y: 60 });
    expect(readingPlace({ x: 100, y: 60 }, true, canvas)).toEqual({ x: 250, y: 60 });
    expect(readingPlace({ x: 500, y: 500 }, false, canvas)).toEqual({ x: 500, y: 466 });
  });

  it('show while arrow keys move something, with how far the next thing is', async () => {
    const { editor, key, look } = await toolsOver('select', [samples.wall]);
    editor.select({ ids: ['wall'], robot: false });
    key('ArrowRight');
    key('ArrowRight');
    expect(look().words.join()).toContain('→ 2.0 cm');
  });
});

describe('numbers typed while something is drawn', () => {
  it('make it as long as that, and Enter ends it there, whatever the pointer does', async () => {
    const { down, move, up, look, key, only, steps } = await toolsOver('wall');
    down(100, 500);
    move(400, 502);
    expect(['3', '5', '.', '5'].map((digit) => key(digit))).toEqual([true, true, true, true]);
    expect(look().words.join()).toContain('35.5▏cm');
    key('Enter');
    expect(only()).toMatchObject({ from: [100, 500], to: [455, 500] });
    move(900, 100);
    up(900, 100);
    expect([only(), steps()]).toMatchObject([{ to: [455, 500] }, 1]);
  });

  it('count when the button goes up, and Tab leads to the second one', async () => {
    const { editor, down, move, up, key, only } = await toolsOver('zone');
    editor.setOptions({ zone: 'forbidden' });
    down(100, 500);
    move(300, 600);
    for (const name of ['4', '0', 'Tab', '3', '0']) key(name);
    up(300, 600);
    expect(only()).toMatchObject({ size: [400, 300], at: [300, 650] });
  });

  it('are left with Escape, the drag goes on', async () => {
    const { down, move, up, key, only } = await toolsOver('wall');
    down(100, 500);
    move(400, 500);
    key('9');
    key('Escape');
    up(400, 500);
    expect(only()).toMatchObject({ to: [400, 500] });
  });

  it('work with the crosshair of the keyboard, too, and are told', async () => {
    const { key, only, said } = await toolsOver('wall');
    key('ArrowRight'); // the crosshair shows in the middle
    key('Enter');
    key('2');
    key('5');
    expect(said.at(-1)).toBe('25');
    key('Enter');
    expect(only()).toMatchObject({ from: [600, 450], to: [850, 450] });
  });

  it('are left alone where nothing is drawn', async () => {
    const { key } = await toolsOver('wall');
    expect(key('3')).toBe(false);
  });
});
