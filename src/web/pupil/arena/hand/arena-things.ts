import type { Pose, Vec } from '#core/geometry';
import type { PlacedBlock } from '../model/arena-model';
import { toMm, type ArenaSize, type View } from '../view/view-transform';
import { keepInside } from './hand-gesture';
import { isNear, isSameThing, type HeldThing } from './held-thing';
import { robotRadiusMm, targetAt, type RobotShape, type Target } from './hit-test';

/** The things in the arena; read afresh each time. */
export interface ThingPorts {
  readonly view: () => View;
  readonly arena: () => ArenaSize;
  /** According to the run or the course, not to the hand that holds it. A newer snapshot brings a new `pose` object. */
  readonly robot: () => RobotShape | null;
  readonly blocks: () => readonly PlacedBlock[];
  /** Wall time in ms. */
  readonly nowMs: () => number;
}

/** A thing that was put down, until the run has processed it. */
interface PutDown {
  readonly thing: HeldThing;
  readonly pose: Pose;
  readonly before: Pose | null;
  readonly atMs: number;
}

/** Snapshots in transit when the hand lets go may still show the old place: they are ignored for this long. */
const SETTLE_MS = 250;

/** Distance that counts as a hit, in CSS px: a finger's target is 44 px wide. */
const REACH_PX = { touch: { slop: 10, touch: 22 }, mouse: { slop: 2, touch: 12 } };

/** The robot and the blocks as a hand finds them: where they are, how large, and which of them is at a point. */
export class ArenaThings {
  private put: PutDown | null = null;

  constructor(private readonly ports: ThingPorts) {}

  /** Pose of a thing in the run, or in the course; `null`: it is not there. */
  sourcePose(thing: HeldThing): Pose | null {
    if (thing.kind === 'robot') return this.ports.robot()?.pose ?? null;
    return this.block(thing)?.pose ?? null;
  }

  /** Shows the thing at `pose` until the run has it there, too. */
  putDown(thing: HeldThing, pose: Pose): void {
    this.put = { thing, pose, before: this.sourcePose(thing), atMs: this.ports.nowMs() };
  }

  /**
   * Pose at which to show a thing that is not held: where it was just put down, or else `pose`, its place in the run.
   */
  settledPose(thing: HeldThing, pose: Pose): Pose {
    const { put } = this;
    if (put === null || !isSameThing(put.thing, thing)) return pose;
    const settling = this.ports.nowMs() - put.atMs < SETTLE_MS && put.before !== null && isNear(put.before, pose);
    if (pose === put.before || settling) return put.pose;
    this.put = null;
    return pose;
  }

  /**
   * Finds the thing at a point of the canvas.
   *
   * @param at in CSS px
   * @param touch true for a finger, which reaches further
   * @param shown the poses at which things are shown, and the knob of the ring, in CSS px
   */
  targetAt(
    at: Vec,
    touch: boolean,
    shown: { readonly poseOf: (thing: HeldThing, pose: Pose) => Pose; readonly knobPx: Vec | null },
  ): Target {
    const view = this.ports.view();
    const robot = this.ports.robot();
    const reach = touch ? REACH_PX.touch : REACH_PX.mouse;
    return targetAt(
      toMm(view, at),
      {
        robot: robot && { ...robot, pose: shown.poseOf({ kind: 'robot' }, robot.pose) },
        knobMm: shown.knobPx && toMm(view, shown.knobPx),
        blocks: this.ports
          .blocks()
          .map((block) => ({ ...block, pose: shown.poseOf({ kind: 'block', id: block.id }, block.pose) })),
      },
      { slopMm: reach.slop / view.pxPerMm, touchMm: reach.touch / view.pxPerMm },
    );
  }

  /**
   * Least distance at which a thing trails behind the pointer, in mm: half the robot's radius, 0.7 of a block's shorter
   * side.
   */
  armMm(thing: HeldThing): number {
    const robot = this.ports.robot();
    if (thing.kind === 'robot') return robot === null ? 0 : 0.5 * robotRadiusMm(robot);
    return 1.4 * this.blockMargin(thing);
  }

  /** The pose, moved into the arena if necessary. */
  inside(thing: HeldThing, pose: Pose): Pose {
    const robot = this.ports.robot();
    // Chosen: 0.6 of the radius is about the robot's narrow side, so it can be placed along a wall.
    const margin = thing.kind === 'robot' && robot !== null ? 0.6 * robotRadiusMm(robot) : this.blockMargin(thing);
    return keepInside(pose, this.ports.arena(), margin);
  }

  private blockMargin(thing: HeldThing): number {
    const size = this.block(thing)?.sizeMm;
    return size === undefined ? 0 : Math.min(size.x, size.y) / 2;
  }

  private block(thing: HeldThing): PlacedBlock | undefined {
    return thing.kind === 'block' ? this.ports.blocks().find(({ id }) => id === thing.id) : undefined;
  }
}
