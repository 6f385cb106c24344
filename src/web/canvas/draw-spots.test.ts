import { describe, expect, it } from 'vitest';
import { spotLabels, type SensorSpot } from './draw-spots';

const view = { pxPerMm: 1, leftPx: 0, bottomPx: 1000 };
const five: SensorSpot[] = [
  { name: 'R2', atMm: { x: 40, y: -36 }, bright: false, reading: 100 },
  { name: 'R1', atMm: { x: 60, y: -12 }, bright: true, reading: 230.4 },
  { name: 'M', atMm: { x: 60, y: 0 }, bright: true, reading: 231 },
  { name: 'L1', atMm: { x: 60, y: 12 }, bright: true, reading: 232 },
  { name: 'L2', atMm: { x: 40, y: 36 }, bright: true, reading: 233 },
];

describe('the readings of line sensors in the arena', () => {
  it('stand from left to right ahead of a robot that looks up, whole numbers, 32 px apart', () => {
    const labels = spotLabels(view, { xMm: 300, yMm: 400, headingRad: Math.PI / 2 }, 1, 80, five);
    expect(labels.map(({ text }) => text)).toEqual(['233', '232', '231', '230', '100']);
    expect(labels.map(({ at }) => Math.round(at.x))).toEqual([236, 268, 300, 332, 364]);
    expect(labels.map(({ at }) => Math.round(at.y))).toEqual([500, 500, 500, 500, 500]);
    expect(labels[0]?.from.x).toBeCloseTo(264, 6);
    expect(labels[0]?.from.y).toBeCloseTo(560, 6);
  });

  it('stand one above the other ahead of a robot that looks to the right', () => {
    const labels = spotLabels(view, { xMm: 300, yMm: 400, headingRad: 0 }, 1, 80, five);
    expect(labels.map(({ at }) => Math.round(at.x))).toEqual([400, 400, 400, 400, 400]);
    expect(labels.map(({ at }) => Math.round(at.y))).toEqual([556, 578, 600, 622, 644]);
  });

  it('are wide enough for four digits: 39 px apart', () => {
    const millivolts = five.map((spot) => ({ ...spot, reading: 2800 }));
    const [one, other] = spotLabels(view, { xMm: 0, yMm: 0, headingRad: Math.PI / 2 }, 1, 80, millivolts);
    expect((other?.at.x ?? 0) - (one?.at.x ?? 0)).toBeCloseTo(39, 6);
  });

  it('never cover each other, wherever the robot looks', () => {
    for (let degrees = 0; degrees < 360; degrees += 7) {
      const labels = spotLabels(view, { xMm: 0, yMm: 0, headingRad: (degrees * Math.PI) / 180 }, 1, 80, five);
      const [one, other] = labels;
      const [dx, dy] = [
        Math.abs((one?.at.x ?? 0) - (other?.at.x ?? 0)),
        Math.abs((one?.at.y ?? 0) - (other?.at.y ?? 0)),
      ];
      expect(dx >= 29 || dy >= 19, `${String(degrees)}°`).toBe(true);
    }
  });

  it('begin at the sensors of a robot twice as large', () => {
    const [label] = spotLabels(view, { xMm: 300, yMm: 400, headingRad: 0 }, 2, 160, five);
    expect(label?.from).toEqual({ x: 380, y: 528 });
  });

  it('are none where a robot knows only light and dark', () => {
    const spots = [{ name: 'left', atMm: { x: 34, y: 7 }, bright: true }];
    expect(spotLabels(view, { xMm: 0, yMm: 0, headingRad: 0 }, 1, 58, spots)).toEqual([]);
  });
});
