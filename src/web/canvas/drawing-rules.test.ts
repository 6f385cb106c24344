import { describe, expect, it } from 'vitest';
import { arranged, lieStill, summaryOf } from './arranged';
import { coneBox, distanceLabel, labelPlace, withAlpha } from './draw-cone';
import { gridSteps } from './draw-floor';
import { floorLight } from './draw-glow';
import { headingLabel, placeLabel } from './draw-hand';
import { rulerTicks } from './draw-rulers';
import { resolutionStep } from './robot-sprite';
import { elementsOf, readSvgTree } from './svg-tree';
import type { Scene } from '#scene/scene';

describe('the rulers', () => {
  it('carry a number each 10 cm and a mark each 2 cm on an arena of 800 mm that is 640 px wide', () => {
    const ticks = rulerTicks(800, 0.8);
    expect(ticks.filter((tick) => tick.label !== null).map((tick) => tick.label)).toEqual([
      ...['0', '10', '20', '30', '40', '50', '60', '70', '80'],
    ]);
    expect(ticks[1]?.mm).toBe(20);
  });

  it('carry a number each metre on an arena of 10 m', () => {
    const labels = rulerTicks(10_000, 0.06).flatMap((tick) => tick.label ?? []);
    expect(labels.slice(0, 3)).toEqual(['0', '100', '200']);
  });
});

describe('the grid', () => {
  it('has lines each 5 cm at 0.7 px per mm, each cm at 2 px per mm', () => {
    expect(gridSteps(0.7)).toEqual({ fineMm: 10, mm: 50, strongMm: 500 });
    expect(gridSteps(2)).toEqual({ fineMm: 5, mm: 10, strongMm: 100 });
  });
});

describe('the light under the robot', () => {
  it('keeps its hue and fades with its brightness', () => {
    const dim = floorLight([0, 0, 25]);
    const full = floorLight([0, 0, 255]);
    expect(dim.color).toEqual(full.color);
    expect(dim.alpha).toBeGreaterThan(0.2);
    expect(dim.alpha).toBeLessThan(full.alpha / 2);
  });

  it('is nothing when it is off', () => expect(floorLight([0, 0, 0]).alpha).toBe(0));

  it('is a light blue when it is white: white on a white floor could not be seen', () => {
    expect(floorLight([255, 255, 255]).color).toEqual([150, 200, 255]);
  });
});

describe('labels', () => {
  it('say 9 cm for 91 mm, 45 degrees and 30.5 | 45 cm', () => {
    expect(distanceLabel(91)).toBe('9 cm');
    expect(headingLabel(Math.PI / 4)).toBe('45°');
    expect(headingLabel(-Math.PI)).toBe('180°');
    expect(placeLabel({ xMm: 305, yMm: 450.2, headingRad: 0 })).toBe('30.5 | 45 cm');
  });

  it('lie above the hit point, whichever way the robot looks', () => {
    for (const heading of [0, 1, 2, 3, 4, 5, 6]) expect(labelPlace({ x: 0, y: 0 }, heading).y).toBeLessThanOrEqual(0);
  });

  it('lie on a ground of 10 % orange', () => expect(withAlpha('#E06A00', 0.1)).toBe('#E06A001a'));
});

describe('the cone', () => {
  it('takes 580 px of a picture at 1 px per mm when it looks to the right and meets nothing', () => {
    const cone = { fromMm: { x: 0, y: 0 }, headingRad: 0, openingRad: 0.5, distanceMm: null, hitMm: null };
    const box = coneBox(cone, { pxPerMm: 1, leftPx: 0, bottomPx: 0 });
    expect(box.left + box.width).toBeGreaterThanOrEqual(450);
    expect(box.width).toBeLessThan(470);
    expect(box.height).toBeGreaterThanOrEqual(2 * 450 * Math.sin(0.25));
  });
});

describe('the robot as pixels', () => {
  it('is made in steps of √2, never coarser than the screen and at most 24 pixels per mm', () => {
    expect(Math.SQRT2 ** resolutionStep(2)).toBeCloseTo(2);
    expect(Math.SQRT2 ** resolutionStep(2.1)).toBeGreaterThan(2.1);
    expect(Math.SQRT2 ** resolutionStep(1000)).toBeLessThan(25);
  });
});

describe('an SVG text', () => {
  it('is read into a tree that knows where each element starts and ends', () => {
    const text = '<svg><!-- <g> --><g id="a"><path d="M0>1"/></g><rect/></svg>';
    const elements = [...elementsOf(readSvgTree(text))];
    expect(elements.map(({ name }) => name)).toEqual(['#document', 'svg', 'g', 'path', 'rect']);
    const group = elements[2]!;
    expect(text.slice(group.start, group.end)).toBe('<g id="a"><path d="M0>1"/></g>');
  });

  it('with an element that is never closed is read to its end', () => {
    expect([...elementsOf(readSvgTree('<svg><g>'))]).toHaveLength(3);
  });
});

describe('the arena before and during a run', () => {
  const scene: Scene = {
    name: '',
    description: '',
    size: [1200, 900],
    board: null,
    robot: { type: null, at: [600, 450], heading: 270, scale: 1 },
    objects: [
      { type: 'block', id: 'b', at: [100, 100], size: [50, 50], turn: 2 },
      { type: 'fixed-block', id: 'f', at: [300, 100], size: [50, 50], turn: 0 },
    ],
  };
  const moved = { xMm: 120, yMm: 100, headingRad: 1 };

  it('shows the robot at its start and the block that can be pushed turned by 90°', () => {
    const { robot, blocks } = arranged(scene, null);
    expect(robot?.pose.xMm).toBe(600);
    expect(blocks.map(({ id, pose }) => [id, pose.headingRad])).toEqual([['b', Math.PI / 2]]);
  });

  it('shows the block where the run has pushed it', () => {
    const snapshot = { timeUs: 0, display: [], robot: null, blocks: { b: moved } };
    const during = arranged(scene, snapshot);
    expect(during.robot).toBeNull();
    expect(during.blocks[0]?.pose).toEqual(moved);
    expect(lieStill(arranged(scene, null).blocks, during.blocks)).toBe(false);
    expect(lieStill(during.blocks, arranged(scene, snapshot).blocks)).toBe(true);
  });

  it('is summed up as 60 cm, 45 cm, -90 degrees, no distance', () => {
    const { robot } = arranged(scene, null);
    expect(summaryOf(robot)).toEqual({ xCm: 60, yCm: 45, headingDeg: -90, distanceCm: null });
    expect(summaryOf(null)).toBeNull();
  });
});
