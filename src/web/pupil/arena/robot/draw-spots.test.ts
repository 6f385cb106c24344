import { describe, expect, it } from 'vitest';
import { spotLabels, type LabelRow, type SensorSpot } from './draw-spots';

const view = { pxPerMm: 1, leftPx: 0, bottomPx: 1000 };
const row: LabelRow = { frontMm: 80, backMm: 30, sight: { left: -1e4, top: -1e4, width: 2e4, height: 2e4 }, hit: null };
const five: SensorSpot[] = [
  { name: 'R2', atMm: { x: 40, y: -36 }, bright: false, reading: 100 },
  { name: 'R1', atMm: { x: 60, y: -12 }, bright: true, reading: 230.4 },
  { name: 'M', atMm: { x: 60, y: 0 }, bright: true, reading: 231 },
  { name: 'L1', atMm: { x: 60, y: 12 }, bright: true, reading: 232 },
  { name: 'L2', atMm: { x: 40, y: 36 }, bright: true, reading: 233 },
];

describe('the readings of line sensors in the arena', () => {
  it('stand from left to right ahead of a robot that looks up, whole numbers, 32 px apart', () => {
    const labels = spotLabels(view, { xMm: 300, yMm: 400, headingRad: Math.PI / 2 }, 1, row, five);
    expect(labels.map(({ text }) => text)).toEqual(['233', '232', '231', '230', '100']);
    expect(labels.map(({ at }) => Math.round(at.x))).toEqual([236, 268, 300, 332, 364]);
    expect(labels.map(({ at }) => Math.round(at.y))).toEqual([500, 500, 500, 500, 500]);
    expect(labels[0]?.from.x).toBeCloseTo(264, 6);
    expect(labels[0]?.from.y).toBeCloseTo(560, 6);
  });

  it('stand one above the other ahead of a robot that looks to the right', () => {
    const labels = spotLabels(view, { xMm: 300, yMm: 400, headingRad: 0 }, 1, row, five);
    expect(labels.map(({ at }) => Math.round(at.x))).toEqual([405, 405, 405, 405, 405]);
    expect(labels.map(({ at }) => Math.round(at.y))).toEqual([556, 578, 600, 622, 644]);
  });

  it('are wide enough for four digits: 39 px apart', () => {
    const millivolts = five.map((spot) => ({ ...spot, reading: 2800 }));
    const [one, other] = spotLabels(view, { xMm: 0, yMm: 0, headingRad: Math.PI / 2 }, 1, row, millivolts);
    expect((other?.at.x ?? 0) - (one?.at.x ?? 0)).toBeCloseTo(39, 6);
  });

  it('never cover each other, wherever the robot looks', () => {
    for (let degrees = 0; degrees < 360; degrees += 7) {
      const labels = spotLabels(view, { xMm: 0, yMm: 0, headingRad: (degrees * Math.PI) / 180 }, 1, row, five);
      const [one, other] = labels;
      const [dx, dy] = [
        Math.abs((one?.at.x ?? 0) - (other?.at.x ?? 0)),
        Math.abs((one?.at.y ?? 0) - (other?.at.y ?? 0)),
      ];
      expect(dx >= 29 || dy >= 19, `${String(degrees)}°`).toBe(true);
    }
  });

  it('begin at the sensors of a robot twice as large', () => {
    const [label] = spotLabels(
      view,
      { xMm: 300, yMm: 400, headingRad: 0 },
      2,
      { ...row, frontMm: 160, backMm: 60 },
      five,
    );
    expect(label?.from).toEqual({ x: 380, y: 528 });
  });

  it('are none where a robot knows only light and dark', () => {
    const spots = [{ name: 'left', atMm: { x: 34, y: 7 }, bright: true }];
    expect(spotLabels(view, { xMm: 0, yMm: 0, headingRad: 0 }, 1, row, spots)).toEqual([]);
  });

  it('stand behind the robot where the rim of the arena is just ahead', () => {
    const sight = { left: 0, top: 0, width: 600, height: 700 };
    const labels = spotLabels(view, { xMm: 300, yMm: 930, headingRad: Math.PI / 2 }, 1, { ...row, sight }, five);
    expect(labels.map(({ at }) => Math.round(at.y))).toEqual([120, 120, 120, 120, 120]);
  });

  it('stand behind the robot too where the label of the distance would cover them', () => {
    const at = { xMm: 300, yMm: 400, headingRad: Math.PI / 2 };
    const [near] = spotLabels(view, at, 1, { ...row, hit: { x: 300, y: 470 } }, five);
    const [far] = spotLabels(view, at, 1, { ...row, hit: { x: 300, y: 300 } }, five);
    expect([near?.at.y, far?.at.y]).toEqual([650, 500]);
  });

  it('move aside along a wall: none of the five is lost', () => {
    const sight = { left: 0, top: 0, width: 600, height: 1000 };
    const labels = spotLabels(view, { xMm: 40, yMm: 400, headingRad: Math.PI / 2 }, 1, { ...row, sight }, five);
    expect(labels.map(({ at }) => Math.round(at.x))).toEqual([18, 50, 82, 114, 146]);
    expect(labels.every(({ at }) => at.y === 500)).toBe(true);
  });

  it('are left out where they would be wider than three robots, as six of them on a small picture', () => {
    const pose = { xMm: 300, yMm: 400, headingRad: 0 };
    const six = [...five, { name: 'R3', atMm: { x: 10, y: -40 }, bright: true, reading: 234 }];
    expect(spotLabels({ ...view, pxPerMm: 0.55 }, pose, 1, row, six)).toEqual([]);
    expect(spotLabels({ ...view, pxPerMm: 0.55 }, pose, 1, row, five)).toHaveLength(5);
    expect(spotLabels({ ...view, pxPerMm: 0.65 }, pose, 1, row, six)).toHaveLength(6);
    expect(spotLabels({ ...view, pxPerMm: 0.3 }, pose, 2, row, six)).toHaveLength(6);
  });
});
