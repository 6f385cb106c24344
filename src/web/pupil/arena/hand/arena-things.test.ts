import { describe, expect, it } from 'vitest';
import type { Pose, Vec } from '#core/geometry';
import type { PlacedBlock } from '../model/arena-model';
import { ArenaThings } from './arena-things';
import type { HeldThing } from './held-thing';
import type { Target } from './hit-test';

const ROBOT: HeldThing = { kind: 'robot' };
const BLOCK: HeldThing = { kind: 'block', id: 'b' };
const at = (xMm: number, yMm: number, headingRad = 0): Pose => ({ xMm, yMm, headingRad });

/** A robot of 100 × 80 mm in the middle of an arena of 1000 × 800 mm, and a block of 40 × 20 mm; 1 px is 1 mm. */
function arena(changes: { readonly robot?: Pose | null; readonly blocks?: readonly PlacedBlock[] } = {}) {
  const now = {
    ms: 0,
    robot: changes.robot === undefined ? at(500, 400) : changes.robot,
    blocks: changes.blocks ?? [{ id: 'b', pose: at(200, 200), sizeMm: { x: 40, y: 20 } }],
  };
  const corners: readonly Vec[] = [
    { x: 50, y: -40 },
    { x: 50, y: 40 },
    { x: -50, y: 40 },
    { x: -50, y: -40 },
  ];
  const things = new ArenaThings({
    view: () => ({ pxPerMm: 1, leftPx: 0, bottomPx: 800 }),
    arena: () => [1000, 800],
    robot: () => now.robot && { pose: now.robot, outlineMm: [corners], scale: 1 },
    blocks: () => now.blocks,
    nowMs: () => now.ms,
  });
  const under = (xMm: number, yMm: number, touch = false): Target =>
    things.targetAt({ x: xMm, y: 800 - yMm }, touch, { poseOf: (_thing, pose) => pose, knobPx: null });
  return { now, things, under };
}

describe('what a hand finds in the arena', () => {
  it('is the robot, a block or the floor', () => {
    const { under } = arena();
    expect(under(500, 400)).toEqual({ kind: 'robot' });
    expect(under(200, 200)).toEqual({ kind: 'block', id: 'b' });
    expect(under(800, 100)).toEqual({ kind: 'floor' });
  });

  it('is found from further off by a finger than by the mouse', () => {
    const { under } = arena();
    expect(under(556, 400)).toEqual({ kind: 'floor' });
    expect(under(556, 400, true)).toEqual({ kind: 'robot' });
  });

  it('is found where it is shown, not where the run still has it', () => {
    const { things } = arena();
    const shown = {
      poseOf: (thing: HeldThing, pose: Pose) => (thing.kind === 'robot' ? at(100, 700) : pose),
      knobPx: null,
    };
    expect(things.targetAt({ x: 100, y: 100 }, false, shown)).toEqual({ kind: 'robot' });
    expect(things.targetAt({ x: 500, y: 400 }, false, shown)).toEqual({ kind: 'floor' });
  });

  it('is the knob of the ring before anything below it', () => {
    const { things } = arena();
    const shown = { poseOf: (_thing: HeldThing, pose: Pose) => pose, knobPx: { x: 500, y: 400 } };
    expect(things.targetAt({ x: 505, y: 400 }, false, shown)).toEqual({ kind: 'ring' });
  });

  it('is nothing but the floor in an empty arena', () => {
    const { things, under } = arena({ robot: null, blocks: [] });
    expect(under(500, 400)).toEqual({ kind: 'floor' });
    expect(things.sourcePose(ROBOT)).toBeNull();
    expect(things.sourcePose(BLOCK)).toBeNull();
    expect(things.armMm(ROBOT)).toBe(0);
  });
});

describe('a thing that was put down', () => {
  it('stays there while older pictures of the run still come in', () => {
    const { now, things } = arena();
    things.putDown(ROBOT, at(600, 300));
    expect(things.settledPose(ROBOT, at(500, 400))).toEqual(at(600, 300));
    now.ms = 200;
    expect(things.settledPose(ROBOT, at(500.1, 400))).toEqual(at(600, 300));
  });

  it('goes where the run has it as soon as the run has carried it elsewhere', () => {
    const { things } = arena();
    things.putDown(ROBOT, at(600, 300));
    expect(things.settledPose(ROBOT, at(605, 300))).toEqual(at(605, 300));
    expect(things.settledPose(ROBOT, at(500, 400))).toEqual(at(500, 400)); // from now on the run alone counts
  });

  it('does not stay where it was dropped when the run does not take it: after a quarter of a second the run is right', () => {
    const { now, things } = arena();
    things.putDown(BLOCK, at(300, 300));
    now.ms = 251;
    expect(things.settledPose(BLOCK, at(200, 200))).toEqual(at(200, 200));
  });

  it('does not hold back another thing', () => {
    const { things } = arena();
    things.putDown(BLOCK, at(300, 300));
    expect(things.settledPose(ROBOT, at(500, 400))).toEqual(at(500, 400));
    expect(things.settledPose({ kind: 'block', id: 'other' }, at(50, 50))).toEqual(at(50, 50));
  });
});

describe('a thing in the hand', () => {
  it('stays inside the arena, so far that its narrow side still fits along the wall', () => {
    const { things } = arena();
    const margin = 0.6 * Math.hypot(50, 40);
    expect(things.inside(ROBOT, at(-200, 2000))).toEqual(at(margin, 800 - margin));
    expect(things.inside(BLOCK, at(-200, 2000))).toEqual(at(10, 790));
    expect(things.inside(BLOCK, at(300, 300, 1))).toEqual(at(300, 300, 1));
  });

  it('trails behind the pointer by about half its size', () => {
    const { things } = arena();
    expect(things.armMm(ROBOT)).toBeCloseTo(0.5 * Math.hypot(50, 40));
    expect(things.armMm(BLOCK)).toBeCloseTo(14);
  });
});
