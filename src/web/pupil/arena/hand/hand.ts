import type { Pose, Vec } from '#core/geometry';
import { movePicture, type PicturePorts } from '../view/pinch';
import {
  gripBody,
  gripRing,
  heldPose,
  nudgedPose,
  pulledPose,
  twistedHeading,
  wheelTurnedHeading,
  type Grip,
} from './hand-gesture';
import { ArenaThings, type ThingPorts } from './arena-things';
import { isNear, isSameThing, toVec, type HeldThing } from './held-thing';
import { robotRadiusMm, type RobotShape, type Target } from './hit-test';
import { toMm, toPx, type View } from '../view/view-transform';

/** Everything the hand reads and changes. */
export interface HandPorts extends PicturePorts, ThingPorts {
  readonly place: (thing: HeldThing, pose: Pose) => void;
  /** True if nothing may be taken; an attempt shows why. Left out: everything may. */
  readonly refuses?: () => boolean;
  /** Called when the picture has changed. */
  readonly changed: () => void;
}

/** A pointer going down. */
export interface Press {
  readonly id: number;
  /** CSS px on the canvas. */
  readonly at: Vec;
  /** A finger, which needs larger targets than a mouse or a pen. */
  readonly touch: boolean;
  /** Moves the picture regardless of the thing under the pointer (the middle button). */
  readonly pansOnly: boolean;
}

interface Hold {
  readonly thing: HeldThing;
  /** The pointer that took hold, or `null`: the keyboard. */
  readonly pointer: number | null;
  readonly startPose: Pose;
  grip: Grip;
  pose: Pose;
  /** The second finger, which turns the thing held by the first one. */
  twist: { readonly pointer: number; readonly from: readonly [Vec, Vec]; readonly headingRad: number } | null;
  moved: boolean;
}

/**
 * The hand over the arena: picks up the robot and blocks, turns the robot by its ring, moves and zooms the picture.
 * Gets pointer and key events as plain data, so it can be tested without a browser.
 */
export class Hand {
  private readonly pointers = new Map<number, Vec>();
  private hold: Hold | null = null;
  private readonly things: ArenaThings;
  private hover: Target = { kind: 'floor' };
  private hoverRing = false;
  private selected = false;
  private focused = false;

  constructor(private readonly ports: HandPorts) {
    this.things = new ArenaThings(ports);
  }

  /** The held thing, and whether it is being turned. */
  get held(): { readonly thing: HeldThing; readonly turning: boolean } | null {
    if (this.hold === null) return null;
    return { thing: this.hold.thing, turning: this.hold.grip.kind === 'turn' || this.hold.twist !== null };
  }

  /** True if the ring around the robot is shown. */
  get ringShows(): boolean {
    if (this.ports.robot() === null) return false;
    return this.selected || this.focused || this.hoverRing || this.hold?.thing.kind === 'robot';
  }

  /** The CSS cursor for the thing under the pointer. */
  get cursor(): string {
    if (this.hold !== null) return 'grabbing';
    return this.hover.kind === 'floor' ? 'default' : 'grab';
  }

  /** Pose at which to show the thing: in the hand, where it was just put down, or else its place in the run. */
  poseOf(thing: HeldThing, pose: Pose): Pose {
    if (this.hold !== null && isSameThing(this.hold.thing, thing)) return this.hold.pose;
    return this.things.settledPose(thing, pose);
  }

  /** Handles a finger or button that is pressed. */
  pointerDown(press: Press): void {
    this.pointers.set(press.id, press.at);
    const hold = this.hold;
    if (hold !== null) {
      if (hold.pointer !== null && hold.twist === null) this.startTwist(hold, press.id);
      return;
    }
    if (this.pointers.size > 1 || press.pansOnly) return;
    const target = this.targetAt(press.at, press.touch);
    this.selected = target.kind === 'robot' || target.kind === 'ring';
    if (target.kind !== 'floor' && !this.isRefused()) this.take(target, press);
    this.ports.changed();
  }

  /**
   * Handles a pointer that moves, pressed or not. The thing it holds turns into the direction of the drag.
   *
   * @param keepsHeading the thing only moves (the Shift key)
   */
  pointerMove(id: number, at: Vec, keepsHeading = false): void {
    const before = this.pointers.get(id);
    if (before === undefined) {
      this.hoverAt(at);
      return;
    }
    this.pointers.set(id, at);
    if (this.hold !== null) this.follow(this.hold, id, keepsHeading);
    else movePicture(this.ports, before, at, [...this.pointers].find(([other]) => other !== id)?.[1]);
  }

  /** Handles a finger or button that is released, and a pointer that the browser has cancelled. */
  pointerUp(id: number): void {
    this.pointers.delete(id);
    const hold = this.hold;
    if (hold === null) return;
    if (hold.pointer === id) this.letGo();
    else if (hold.twist?.pointer === id) {
      hold.twist = null;
      this.regrip(hold, true);
    }
  }

  /** Handles a pointer that leaves the canvas. */
  pointerLeave(): void {
    this.hover = { kind: 'floor' };
    this.hoverRing = false;
    this.ports.changed();
  }

  /** Releases everything, so that a tool can take over. */
  release(): void {
    this.letGo();
    this.pointers.clear();
    this.hover = { kind: 'floor' };
    this.hoverRing = false;
    this.selected = false;
    this.focused = false;
    this.ports.changed();
  }

  /**
   * The wheel turns the held thing.
   *
   * @returns whether the event was used
   */
  wheel(deltaPx: number): boolean {
    const hold = this.hold;
    if (hold === null) return false;
    hold.pose = { ...hold.pose, headingRad: wheelTurnedHeading(hold.pose.headingRad, deltaPx) };
    hold.moved = true;
    this.ports.changed();
    return true;
  }

  /**
   * Handles a key that is pressed: arrows, Q and E move the robot (or the held thing), Escape puts the held thing back.
   *
   * @returns whether the key was used
   */
  keyDown(key: string, fine: boolean): boolean {
    if (key === 'Escape') return this.putBack();
    const robot = this.ports.robot();
    const from = this.hold?.pose ?? (robot === null ? null : this.poseOf({ kind: 'robot' }, robot.pose));
    const pose = from === null ? null : nudgedPose(from, key, fine);
    if (from === null || pose === null) return false;
    if (this.isRefused()) return true;
    const thing: HeldThing = { kind: 'robot' };
    this.hold ??= {
      thing,
      pointer: null,
      startPose: from,
      grip: gripBody(from, toVec(from)),
      pose,
      twist: null,
      moved: true,
    };
    this.hold.pose = this.things.inside(this.hold.thing, pose);
    this.hold.moved = true;
    this.regrip(this.hold);
    this.tick();
    this.ports.changed();
    return true;
  }

  /** Handles a key that is released: a thing held by the keyboard is released. */
  keyUp(): void {
    if (this.hold?.pointer === null) this.letGo();
  }

  /** Notes whether the arena has the focus. */
  focus(focused: boolean): void {
    this.focused = focused;
    if (!focused) {
      this.keyUp();
      this.selected = false;
    }
    this.ports.changed();
  }

  /**
   * To be called once per frame while something is held: reports its place if it was moved, or if the run has carried
   * it off.
   */
  tick(): void {
    const hold = this.hold;
    if (hold === null) return;
    const actual = this.things.sourcePose(hold.thing);
    if (!hold.moved && (actual === null || isNear(actual, hold.pose))) return;
    hold.moved = false;
    this.ports.place(hold.thing, hold.pose);
  }

  /** Place of the ring's knob, in CSS px; `null` while the ring is hidden. */
  knobPx(): Vec | null {
    const robot = this.ports.robot();
    if (robot === null || !this.ringShows) return null;
    const pose = this.poseOf({ kind: 'robot' }, robot.pose);
    const centre = toPx(this.ports.view(), toVec(pose));
    const radius = ringRadiusPx(this.ports.view(), robot);
    return {
      x: centre.x + radius * Math.cos(pose.headingRad),
      y: centre.y - radius * Math.sin(pose.headingRad),
    };
  }

  private isRefused(): boolean {
    return this.ports.refuses?.() === true;
  }

  private take(target: Exclude<Target, { kind: 'floor' }>, press: Press): void {
    const thing: HeldThing = target.kind === 'block' ? target : { kind: 'robot' };
    const source = this.things.sourcePose(thing);
    if (source === null) return;
    const pose = this.poseOf(thing, source);
    const point = toMm(this.ports.view(), press.at);
    const grip = target.kind === 'ring' ? gripRing(pose, point) : gripBody(pose, point, this.things.armMm(thing));
    this.hold = { thing, pointer: press.id, startPose: pose, grip, pose, twist: null, moved: false };
  }

  private startTwist(hold: Hold, pointer: number): void {
    const from = this.twoFingers(hold, pointer);
    if (from !== null) hold.twist = { pointer, from, headingRad: hold.pose.headingRad };
  }

  private twoFingers(hold: Hold, second: number): readonly [Vec, Vec] | null {
    const a = hold.pointer === null ? undefined : this.pointers.get(hold.pointer);
    const b = this.pointers.get(second);
    if (a === undefined || b === undefined) return null;
    return [toMm(this.ports.view(), a), toMm(this.ports.view(), b)];
  }

  private follow(hold: Hold, id: number, keepsHeading: boolean): void {
    const anchor = hold.pointer === null ? undefined : this.pointers.get(hold.pointer);
    if (anchor === undefined || (id !== hold.pointer && id !== hold.twist?.pointer)) return;
    const point = toMm(this.ports.view(), anchor);
    let pose = heldPose(hold.grip, hold.pose, point);
    if (hold.grip.kind === 'move' && hold.twist === null && !keepsHeading) {
      const pulled = pulledPose(hold.grip, hold.pose, point);
      pose = pulled.pose;
      hold.grip = pulled.grip;
    } else if (hold.grip.kind === 'move') hold.grip = { ...hold.grip, pointMm: point };
    if (hold.twist !== null) {
      const now = this.twoFingers(hold, hold.twist.pointer);
      if (now !== null) pose = { ...pose, headingRad: twistedHeading(hold.twist.headingRad, hold.twist.from, now) };
    }
    hold.pose = this.things.inside(hold.thing, pose);
    hold.moved = true;
    this.ports.changed();
  }

  private hoverAt(at: Vec): void {
    const robot = this.ports.robot();
    this.hover = this.targetAt(at, false);
    let near = this.hover.kind === 'robot' || this.hover.kind === 'ring';
    if (robot !== null && this.hoverRing) {
      const centre = toPx(this.ports.view(), toVec(robot.pose));
      near ||= Math.hypot(at.x - centre.x, at.y - centre.y) < ringRadiusPx(this.ports.view(), robot) + 24;
    }
    if (near !== this.hoverRing) this.ports.changed();
    this.hoverRing = near;
  }

  private targetAt(at: Vec, touch: boolean): Target {
    return this.things.targetAt(at, touch, {
      poseOf: (thing, pose) => this.poseOf(thing, pose),
      knobPx: this.knobPx(),
    });
  }

  private putBack(): boolean {
    if (this.hold === null) return false;
    this.hold.pose = this.hold.startPose;
    this.hold.moved = true;
    this.letGo();
    return true;
  }

  private letGo(): void {
    const hold = this.hold;
    if (hold === null) return;
    this.tick();
    this.hold = null;
    this.things.putDown(hold.thing, hold.pose);
    this.ports.changed();
  }

  /** Adjusts the grip after something else has moved the held thing: the pointer holds it at its new place. */
  private regrip(hold: Hold, byBody = hold.grip.kind === 'move'): void {
    const anchor = hold.pointer === null ? undefined : this.pointers.get(hold.pointer);
    if (anchor === undefined || !byBody) return;
    hold.grip = gripBody(hold.pose, toMm(this.ports.view(), anchor), this.things.armMm(hold.thing));
  }
}

/** Radius of the ring around the robot, in CSS px: outside body and attachments, never too small for a finger. */
export function ringRadiusPx(view: View, robot: Omit<RobotShape, 'pose'>): number {
  const radiusMm = Math.max(robotRadiusMm(robot), (robot.frontMm ?? 0) * robot.scale);
  return Math.max(radiusMm * view.pxPerMm + 20, 48);
}
