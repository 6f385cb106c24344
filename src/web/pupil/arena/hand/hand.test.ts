import { describe, expect, it } from 'vitest';
import type { Pose, Vec } from '#core/geometry';
import type { PlacedBlock } from '../model/arena-model';
import { Hand, ringRadiusPx, type HandPorts } from './hand';

/** A view of 1 px per mm: the arena of 1000 × 800 mm fills the canvas, whose y axis points down. */
const px = (x: number, y: number): Vec => ({ x, y: 800 - y });
const outlineMm = [
  [
    { x: 50, y: -40 },
    { x: 50, y: 40 },
    { x: -30, y: 40 },
    { x: -30, y: -40 },
  ],
];

function handOverArena() {
  const now = { ms: 0 };
  const run = {
    robot: { xMm: 500, yMm: 400, headingRad: 0 } as Pose,
    blocks: [{ id: 'b', pose: { xMm: 200, yMm: 200, headingRad: 0 }, sizeMm: { x: 40, y: 40 } }] as PlacedBlock[],
  };
  const placed: string[] = [];
  const picture: string[] = [];
  const ports: HandPorts = {
    view: () => ({ pxPerMm: 1, leftPx: 0, bottomPx: 800 }),
    arena: () => [1000, 800],
    robot: () => ({ pose: run.robot, outlineMm, scale: 1 }),
    blocks: () => run.blocks,
    place: (thing, pose) => {
      const name = thing.kind === 'robot' ? 'robot' : thing.id;
      const deg = Math.round((pose.headingRad * 180) / Math.PI);
      placed.push(`${name} ${String(Math.round(pose.xMm))} ${String(Math.round(pose.yMm))} ${String(deg)}°`);
    },
    pan: (by) => picture.push(`pan ${String(by.x)} ${String(by.y)}`),
    zoom: (factor) => picture.push(`zoom ${factor.toFixed(2)}`),
    changed: () => undefined,
    nowMs: () => now.ms,
  };
  const hand = new Hand(ports);
  const down = (at: Vec, id = 1, touch = false): void => hand.pointerDown({ id, at, touch, pansOnly: false });
  return { hand, run, now, placed, picture, down };
}

describe('the hand', () => {
  it('picks up the robot at the first touch and carries it 100 mm to the right, held where it was touched', () => {
    const { hand, placed, down } = handOverArena();
    down(px(520, 410));
    hand.pointerMove(1, px(620, 410), true); // with Shift the heading does not change
    hand.tick();
    expect(placed).toEqual(['robot 600 400 0°']);
    expect(hand.held).toEqual({ thing: { kind: 'robot' }, turning: false });
  });

  it('turns the robot into the direction of the drag, held where it was touched', () => {
    const { hand, placed, down } = handOverArena();
    down(px(530, 400));
    for (let mm = 10; mm <= 200; mm += 10) hand.pointerMove(1, px(530, 400 + mm));
    hand.tick();
    expect(placed).toEqual(['robot 530 570 90°']); // its middle trails 30 mm behind the hand
  });

  it('tells a pose once a frame, and only when something has changed', () => {
    const { hand, placed, down, run } = handOverArena();
    down(px(500, 400));
    hand.pointerMove(1, px(510, 400));
    hand.pointerMove(1, px(520, 400));
    hand.tick();
    run.robot = { xMm: 520, yMm: 400, headingRad: 0 };
    hand.tick();
    hand.tick();
    expect(placed).toEqual(['robot 520 400 0°']);
  });

  it('puts the robot back into the hand when its motors carry it off by 5 mm', () => {
    const { hand, placed, down, run } = handOverArena();
    down(px(500, 400));
    run.robot = { xMm: 505, yMm: 400, headingRad: 0 };
    hand.tick();
    expect(placed).toEqual(['robot 500 400 0°']);
  });

  it('keeps the robot inside the arena', () => {
    const { hand, placed, down } = handOverArena();
    down(px(500, 400));
    hand.pointerMove(1, px(-300, 400));
    hand.tick();
    expect(placed).toEqual([`robot ${String(Math.round(0.6 * Math.hypot(50, 40)))} 400 0°`]);
  });

  it('turns the robot by the knob of its ring: a quarter turn to the left', () => {
    const { hand, placed, down } = handOverArena();
    down(px(500, 400));
    hand.pointerUp(1);
    const radius = ringRadiusPx({ pxPerMm: 1, leftPx: 0, bottomPx: 0 }, { outlineMm, scale: 1 });
    expect(hand.knobPx()).toEqual(px(500 + radius, 400));
    down(px(500 + radius, 400));
    hand.pointerMove(1, px(500, 400 + radius));
    hand.tick();
    expect(placed).toEqual(['robot 500 400 90°']);
    expect(hand.held?.turning).toBe(true);
  });

  it('has the knob of the ring beyond the claw: 20 px ahead of its tips', () => {
    const view = { pxPerMm: 0.5, leftPx: 0, bottomPx: 0 };
    expect(ringRadiusPx(view, { outlineMm, scale: 1, frontMm: 122 })).toBe(81);
    expect(ringRadiusPx(view, { outlineMm, scale: 2, frontMm: 122 })).toBe(142);
  });

  it('turns what one finger holds with a second finger: 90° to the right', () => {
    const { hand, placed, picture, down } = handOverArena();
    down(px(500, 400), 1, true);
    down(px(700, 400), 2, true);
    hand.pointerMove(2, px(500, 200));
    hand.tick();
    expect(placed).toEqual(['robot 500 400 -90°']);
    expect(picture).toEqual([]);
  });

  it('turns what it holds with the wheel: 15° to the right per notch', () => {
    const { hand, placed, down } = handOverArena();
    expect(hand.wheel(100)).toBe(false);
    down(px(500, 400));
    expect(hand.wheel(100)).toBe(true);
    hand.tick();
    expect(placed).toEqual(['robot 500 400 -15°']);
  });

  it('drags a block and leaves the robot alone', () => {
    const { hand, placed, down } = handOverArena();
    down(px(210, 190));
    hand.pointerMove(1, px(260, 190), true);
    hand.pointerUp(1);
    expect(placed).toEqual(['b 250 200 0°']);
    expect(hand.held).toBeNull();
  });

  it('puts back what it holds at Escape', () => {
    const { hand, placed, down } = handOverArena();
    down(px(500, 400));
    hand.pointerMove(1, px(600, 500), true);
    hand.tick();
    expect(hand.keyDown('Escape', false)).toBe(true);
    expect(placed).toEqual(['robot 600 500 0°', 'robot 500 400 0°']);
  });
});

describe('the hand on the keyboard', () => {
  it('moves the robot 10 mm per arrow, also five times before the run has answered once', () => {
    const { hand, placed } = handOverArena();
    for (let i = 0; i < 5; i += 1) {
      hand.keyDown('ArrowRight', false);
      hand.keyUp();
    }
    expect(placed.at(-1)).toBe('robot 550 400 0°');
  });

  it('turns the robot 15° to the left with Q, 1° to the right with Shift and E', () => {
    const { hand, placed } = handOverArena();
    hand.keyDown('q', false);
    hand.keyDown('E', true);
    expect(placed).toEqual(['robot 500 400 15°', 'robot 500 400 14°']);
  });

  it('leaves other keys to the page', () => {
    const { hand, placed } = handOverArena();
    expect(hand.keyDown('Tab', false)).toBe(false);
    expect(placed).toEqual([]);
  });
});

describe('what the hand has put down', () => {
  it('stays there for 250 ms although snapshots under way still show the old place', () => {
    const { hand, run, now, down } = handOverArena();
    down(px(500, 400));
    hand.pointerMove(1, px(700, 400));
    hand.pointerUp(1);
    const shown = (): number => hand.poseOf({ kind: 'robot' }, run.robot).xMm;
    expect(shown()).toBe(700);
    run.robot = { ...run.robot };
    now.ms = 100;
    expect(shown()).toBe(700);
    run.robot = { ...run.robot, xMm: 702 };
    expect(shown()).toBe(702);
  });

  it('is where the run says after 250 ms', () => {
    const { hand, run, now, down } = handOverArena();
    down(px(500, 400));
    hand.pointerMove(1, px(700, 400));
    hand.pointerUp(1);
    run.robot = { ...run.robot };
    now.ms = 251;
    expect(hand.poseOf({ kind: 'robot' }, run.robot).xMm).toBe(500);
  });
});

describe('the hand on the floor', () => {
  it('moves the picture with one finger', () => {
    const { hand, picture, down } = handOverArena();
    down(px(800, 700));
    hand.pointerMove(1, px(790, 700));
    expect(picture).toEqual(['pan -10 0']);
  });

  it('zooms by 2 when two fingers move from 100 px to 200 px apart', () => {
    const { hand, picture, down } = handOverArena();
    down(px(700, 700), 1, true);
    down(px(800, 700), 2, true);
    hand.pointerMove(2, px(900, 700));
    expect(picture).toEqual(['pan 50 0', 'zoom 2.00']);
  });

  it('shows a grasping cursor over the robot and an arrow over the floor', () => {
    const { hand } = handOverArena();
    hand.pointerMove(1, px(500, 400));
    expect(hand.cursor).toBe('grab');
    expect(hand.ringShows).toBe(true);
    hand.pointerMove(1, px(900, 100));
    expect(hand.cursor).toBe('default');
    expect(hand.ringShows).toBe(false);
  });
});
