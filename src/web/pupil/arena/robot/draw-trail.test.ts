import { afterEach, describe, expect, it, vi } from 'vitest';
import { createTrailLayer, piecesOf, type TrailFrame } from './draw-trail';
import { Trail } from '../../../session/run/trail';
import { lightPalette } from '../model/palette';
import { NodePath, RecordingCanvas } from '../testing/recording-canvas';

const view = { pxPerMm: 1, leftPx: 0, bottomPx: 1000 };

function trailOf(...xyMm: number[]): Trail {
  const trail = new Trail();
  trail.add(xyMm);
  return trail;
}

describe('the drawing of a trail', () => {
  it('turns mm into px, y upwards in the arena and downwards on the canvas', () => {
    expect(piecesOf(trailOf(10, 20, 30, 40), 0, view)).toEqual([[10, 980, 30, 960]]);
  });

  it('has two pieces when the hand carried the robot once', () => {
    expect(piecesOf(trailOf(0, 0, 10, 0, NaN, NaN, 500, 0), 0, view)).toEqual([
      [0, 1000, 10, 1000],
      [500, 1000],
    ]);
  });

  it('goes on from the third point when the first two are drawn already', () => {
    expect(piecesOf(trailOf(0, 0, 10, 0, 20, 0), 2, view)).toEqual([[20, 1000]]);
  });

  it('draws 100 points within 20 px as 16 or fewer, and reaches the last one', () => {
    const [piece = []] = piecesOf(trailOf(...Array.from({ length: 200 }, (_, i) => (i % 2 ? 0 : i / 10))), 0, view);
    expect(piece.length / 2).toBeLessThanOrEqual(16);
    expect(piece.at(-2)).toBeCloseTo(19.8, 4);
  });

  it('leaves to the moving picture what its own canvas does not show yet', () => {
    const layer = createTrailLayer();
    expect(layer.tail(trailOf(0, 0, 10, 0), view)).toEqual([
      { x: 0, y: 1000 },
      { x: 10, y: 1000 },
    ]);
    expect(layer.tail(trailOf(0, 0, 10, 0, NaN, NaN, 70, 0), view)).toEqual([{ x: 70, y: 1000 }]);
  });
});

describe('the canvas that trails share', () => {
  const blue = { ...lightPalette, trace: '#0000ff' };
  const red = { ...lightPalette, trace: '#ff0000' };
  afterEach(() => vi.unstubAllGlobals());

  function canvas() {
    vi.stubGlobal('Path2D', NodePath);
    const recording = new RecordingCanvas();
    const element = { getContext: () => recording.context, style: {}, width: 0, height: 0 };
    const frame: TrailFrame = {
      canvas: element as unknown as HTMLCanvasElement,
      widthPx: 1000,
      heightPx: 1000,
      ratio: 1,
      view,
      arena: [1000, 1000],
    };
    const lines = (color: string) =>
      recording.painted.filter((one) => one.by === 'stroke' && one.color === color && one.right > one.left);
    return { frame, lines };
  }

  it('shows each in its colour, and four times a second only what has been added to it', () => {
    const { frame, lines } = canvas();
    const [one, other] = [trailOf(0, 0, 100, 0), trailOf(0, 500, 100, 500)];
    const trails = [
      { trail: one, palette: blue },
      { trail: other, palette: red },
    ];
    const layer = createTrailLayer();
    layer.paint(trails, frame, 1000);
    const first = { blue: lines(blue.trace).length, red: lines(red.trace).length };
    expect([first.blue > 0, first.red > 0]).toEqual([true, true]);
    other.add([200, 500]);
    layer.paint(trails, frame, 1100);
    expect(lines(red.trace)).toHaveLength(first.red);
    expect(layer.tail(other, view)).toHaveLength(2);
    layer.paint(trails, frame, 1250);
    expect(lines(red.trace).length).toBeGreaterThan(first.red);
    expect(lines(blue.trace)).toHaveLength(first.blue);
    expect(layer.tail(other, view)).toHaveLength(1);
  });

  it('is painted anew when one of them goes away', () => {
    const { frame, lines } = canvas();
    const trails = [
      { trail: trailOf(0, 0, 100, 0), palette: blue },
      { trail: trailOf(0, 500, 100, 500), palette: red },
    ];
    const layer = createTrailLayer();
    layer.paint(trails, frame, 1000);
    const before = lines(blue.trace).length;
    layer.paint(trails.slice(0, 1), frame, 1010);
    expect(lines(blue.trace).length).toBeGreaterThan(before);
  });
});
