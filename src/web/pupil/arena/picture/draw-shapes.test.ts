// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';

import { zone } from '#picture/kinds/zone';
import { defaultScene, type SceneObject } from '#scene/scene';

import { samples } from '../../../app/testing/editing';
import '../../../app/testing/mount-on';
import { lightPalette as palette } from '../model/palette';
import { RecordingCanvas, recordCanvases, type Painted } from '../testing/recording-canvas';
import type { View } from '../view/view-transform';
import { drawScene } from './draw-scene';
import { drawWaiting, type Waiting } from './draw-waiting';
import { liveScene } from './live-scene';
import * as zones from './draw-zones';
import * as sheets from './sheets';
import { createSceneKinds } from './scene-kinds';
import { drawMovableBlock, placedAtStart } from './draw-bodies';
import { drawMover, drawObject } from './draw-object';
import { drawShapes, lookOf } from './draw-shapes';

beforeEach(recordCanvases);

/** 1 px per mm over an arena of 1200 × 900 mm; the upper edge of the canvas is at y = 900 mm. */
const view: View = { pxPerMm: 1, leftPx: 0, bottomPx: 900 };

function drawn(object: SceneObject, at: View = view): RecordingCanvas {
  const canvas = new RecordingCanvas();
  drawObject(canvas.context, at, object, palette);
  return canvas;
}

/** Left, top, right and bottom of all of this, in whole px. */
function boxOf(painted: readonly Painted[]): readonly number[] {
  const [all, least, most] = [painted, Math.min, Math.max];
  return [
    least(...all.map(({ left }) => left)),
    least(...all.map(({ top }) => top)),
    most(...all.map(({ right }) => right)),
    most(...all.map(({ bottom }) => bottom)),
  ].map((px) => Math.round(px));
}

describe('things of a course, as they are drawn', () => {
  it.each(Object.values(samples))('$type becomes visible, where it lies and nowhere else', (object) => {
    const { painted } = drawn(object);
    const [left, top, right, bottom] = boxOf(painted);
    expect(painted.length).toBeGreaterThan(0);
    const near = drawn(object, { ...view, leftPx: 300, bottomPx: 1000 });
    expect(boxOf(near.painted)).toEqual([left! + 300, top! + 100, right! + 300, bottom! + 100]);
  });

  it('a wall has its length and its thickness, and bricks as soon as they can be told apart', () => {
    const body = drawn(samples.wall).in(palette.wall);
    expect(boxOf(body)).toEqual([100, 795, 300, 805]);
    expect(drawn(samples.wall).in(palette.wallLight).length).toBeGreaterThan(0);
    expect(drawn(samples.wall, { ...view, pxPerMm: 0.1 }).in(palette.wallLight)).toEqual([]);
  });

  it('a wall that goes up is as thick across', () => {
    const up = drawn({ ...samples.wall, to: [100, 300] }).in(palette.wall);
    expect(boxOf(up)).toEqual([95, 600, 105, 800]);
  });

  it('a line has its colour and its width at every zoom', () => {
    const [line] = drawn({ ...samples.stroke, color: 'green', width: 30 }).in(palette.strokes.green);
    expect([line?.by, line?.line]).toEqual(['stroke', 30]);
    const large = drawn({ ...samples.stroke, id: 'other', width: 30 }, { ...view, pxPerMm: 3 });
    expect(large.in(palette.strokes.black)[0]?.line).toBeCloseTo(90);
  });

  it('white and yellow lines have a rim, dark ones none', () => {
    const rims = (['white', 'yellow', 'black', 'red'] as const).map(
      (color) => drawn({ ...samples.stroke, color }).in(palette.strokeEdge).length,
    );
    expect(rims).toEqual([1, 1, 0, 0]);
  });

  it('a block that can be pushed does not look like a fixed one', () => {
    const colors = (object: SceneObject) => new Set(drawn(object).painted.map(({ color }) => color));
    const [loose, fixed] = [colors(samples.block), colors(samples['fixed-block'])];
    expect([loose.has(palette.movable), loose.has(palette.fixed)]).toEqual([true, false]);
    expect([fixed.has(palette.movable), fixed.has(palette.fixed)]).toEqual([false, true]);
  });

  it('a block in the hand is lifted: larger, and farther from its shadow', () => {
    const of = (held: boolean) => {
      const canvas = new RecordingCanvas();
      drawMovableBlock(canvas.context, view, placedAtStart(samples.block), held, palette);
      const [left, , right] = boxOf(canvas.in(palette.movable)) as [number, number, number];
      const shadow = boxOf(canvas.in('rgba(0, 0, 0, 0.2)'));
      return { width: right - left, shade: shadow[3]! };
    };
    expect(of(true).width).toBeGreaterThan(of(false).width);
    expect(of(true).shade).toBeGreaterThan(of(false).shade);
  });

  it('a block that is turned by 45° is wider by the diagonal', () => {
    const [left, , right] = boxOf(drawn({ ...samples.block, angle: 45 }).in(palette.movable));
    expect(right! - left!).toBeGreaterThan(60);
    expect((left! + right!) / 2).toBeCloseTo(400, 0);
  });

  it('spikes reach to the edge of their box', () =>
    expect(boxOf(drawn(samples.spikes).in(palette.spikes))).toEqual([1020, 670, 1080, 730]));

  it('a moving block shows its way, dashed, and where it turns round', () => {
    const way = drawn(samples.mover).painted.filter(({ dashed }) => dashed);
    expect(boxOf(way)).toEqual([900, 475, 1125, 525]);
  });

  it('a moving block is drawn where the run has it, with teeth only when it is spiked', () => {
    const at = (spiked: boolean) => {
      const canvas = new RecordingCanvas();
      const pose = { xMm: 1000, yMm: 400, headingRad: 0 };
      drawMover(canvas.context, view, { ...samples.mover, spiked }, pose, palette);
      return canvas;
    };
    const [body] = at(false).in(palette.mover);
    expect((body!.left + body!.right) / 2).toBeCloseTo(1000);
    expect([at(false).in(palette.spikes).length > 0, at(true).in(palette.spikes).length > 0]).toEqual([false, true]);
  });

  it('words are written where they lie, and not at all where they would be a smudge', () => {
    const canvas = drawn(samples.label);
    expect(canvas.words).toEqual(['Hallo']);
    const [words] = canvas.in(palette.label);
    expect([words?.left, Math.round(words!.top)]).toEqual([500, 115]); // the foot of capitals of 30 mm
    expect(drawn(samples.label, { ...view, pxPerMm: 0.01 }).painted).toEqual([]);
  });
});

describe('zones, as they are drawn', () => {
  it.each(['target', 'checkpoint', 'forbidden'] as const)('%s has a ground of its own colour', (type) => {
    const zone = { ...samples[type], round: false };
    const ground = drawn(zone).in(palette[`${type}Fill`]);
    const [x, y] = zone.at;
    const [half] = zone.size.map((side) => side / 2) as [number];
    expect(boxOf(ground)).toEqual([x - half, 900 - y - half, x + half, 900 - y + half]);
  });

  it('a target has dashes around it, what is forbidden a line without gaps', () => {
    const rim = (type: 'target' | 'forbidden') =>
      drawn({ ...samples[type], round: false })
        .in(palette[type])
        .filter(({ by }) => by === 'stroke');
    expect(rim('target').some(({ dashed }) => dashed)).toBe(true);
    expect(rim('forbidden').some(({ dashed }) => dashed)).toBe(false);
  });

  it('a checkpoint has its number, a target the blocks that it wants', () => {
    expect(drawn({ ...samples.checkpoint, number: 12 }).words).toEqual(['12']);
    expect(drawn({ ...samples.target, blocks: 3 }).words).toEqual(['3×']);
    expect(drawn(samples.target).words).toEqual([]);
    expect(drawn(samples.forbidden).words).toEqual([]);
  });

  it('keeps its number upright however the zone is turned', () => {
    const at = (angle: number) => {
      const [number] = drawn({ ...samples.checkpoint, angle }).painted.filter(({ by }) => by === 'text');
      return [number?.left, number?.top];
    };
    expect(at(135)).toEqual(at(0));
  });

  it('has a check mark instead of its number once it is reached', () => {
    const signs = (state: 'open' | 'reached') => {
      const canvas = new RecordingCanvas();
      const sign = zone.sign?.(samples.checkpoint, lookOf(view, palette), state === 'reached');
      drawShapes(canvas.context, view, sign ?? []);
      return [canvas.words.length, canvas.in(palette.reached).length];
    };
    expect([signs('open'), signs('reached')]).toEqual([
      [1, 0],
      [0, 1],
    ]);
  });

  it('leaves its sign out where it could not be read', () =>
    expect(drawn(samples.checkpoint, { ...view, pxPerMm: 0.05 }).words).toEqual([]));
});

describe('the picture of a course', () => {
  const canvas = { widthPx: 1200, heightPx: 900 };
  const picture = (objects: readonly SceneObject[], hasKinds = true) => {
    const on = new RecordingCanvas();
    const scene = { ...defaultScene(), objects };
    const kinds = hasKinds ? createSceneKinds(() => undefined) : null;
    drawScene(
      on.context,
      view,
      { scene, zones: hasKinds ? zones : null, sheets: hasKinds ? sheets : null, kinds, verdict: null },
      canvas,
      palette,
    );
    return on;
  };
  const firstOf = (on: RecordingCanvas, color: string) => on.painted.findIndex((one) => one.color === color);

  it('has the line over the ground of a zone, and the wall over the line', () => {
    const on = picture([samples.wall, samples.stroke, samples.target]);
    const order = [palette.floor, palette.targetFill, palette.strokes.black, palette.wall].map((it) => firstOf(on, it));
    expect(order.every((at) => at >= 0)).toBe(true);
    expect(order).toEqual([...order].sort((a, b) => a - b));
  });

  it('leaves out what moves by itself or can be pushed: it has a layer of its own', () => {
    const on = picture([samples.block, samples.mover]);
    expect([on.in(palette.movable), on.in(palette.mover)]).toEqual([[], []]);
    expect(on.in(palette.moverInk).length).toBeGreaterThan(0); // its way lies on the floor
  });

  it('shows lines, walls and fixed blocks before the drawing of the rest has come', () => {
    const on = picture(Object.values(samples), false);
    expect(on.in(palette.wall).length).toBeGreaterThan(0);
    expect(on.in(palette.fixed).length).toBeGreaterThan(0);
    expect([on.in(palette.targetFill), on.in(palette.spikes)]).toEqual([[], []]);
  });

  it('ends with the rim around the whole floor', () => {
    const rim = picture([]).in(palette.floorEdge);
    expect(boxOf(rim)).toEqual([-1, -1, 1201, 901]);
  });
});

describe('what waits for the next start', () => {
  const waiting = (more: Partial<Waiting['live']>, start: Waiting['start'] = null) => {
    const on = new RecordingCanvas();
    const course = { ...defaultScene(), objects: [samples.block] };
    const robot = [[{ x: -50, y: -40 }, { x: 50, y: -40 }, { x: 50, y: 40 }, { x: -50, y: 40 }]]; // prettier-ignore
    const live = { ...liveScene(course, course), ...more };
    drawWaiting(on.context, view, { live, start, footprint: robot, ratio: 1 }, palette);
    return on;
  };

  it('is pale, in a dashed frame', () => {
    const on = waiting({ waiting: [samples.wall] });
    expect(on.in(palette.wall).every(({ alpha }) => alpha < 0.5)).toBe(true);
    const [frame] = on.in(palette.hand);
    expect([frame?.dashed, frame?.alpha]).toEqual([true, 1]);
    expect(boxOf([frame!])).toEqual([97, 792, 303, 808]);
  });

  it('frames what will be gone, which is still there', () => {
    const on = waiting({ leaving: new Set(['block']) });
    expect(boxOf(on.in(palette.hand))).toEqual([372, 672, 428, 728]);
    expect(on.in(palette.movable)).toEqual([]);
  });

  it('shows how large the arena will be', () =>
    expect(boxOf(waiting({ size: [600, 400] }).in(palette.hand))).toEqual([0, 500, 600, 900]));

  it('shows where the robot will start, turned as it will stand', () => {
    const start = { ...defaultScene().robot, at: [300, 300] as const, heading: 90, scale: 1 };
    const [outline] = waiting({}, start).in(palette.trace);
    expect(outline?.dashed).toBe(true);
    expect(boxOf([outline!])).toEqual([260, 550, 340, 650]);
  });

  it('is nothing while the run knows all of the course', () => expect(waiting({}).painted).toEqual([]));
});
