/**
 * The line patrol of the Maqueen Plus V3: its controller follows a line and takes junctions as it was told. DFRobot publishes
 * the registers only; how it drives is chosen: the rule for three sensors of ../line-walking, and for junctions the two
 * sensors at the sides.
 *
 *        ╷                      While it follows the line, a side sensor sees a branch. It goes straight on for 30 mm and
 *     ───┼───  L2 L1 M R1 R2    looks whether the line goes on ahead of it and which sides have branches. To turn off, it
 *        │                      drives on until its axle is at the branch and turns until M sees a line again.
 */
import { STEP_S } from '#world/step';
import { createLineWalker } from '../line-walking';
import type { LineName } from '../maqueen-plus-frame';
import { rimMm } from './moves';
import type { Wheels } from './wheels';

/** The values of register 61. A corner without a way straight on is no junction. */
export const JUNCTION = { none: 0, crossing: 1, tee: 2, leftOrStraight: 3, rightOrStraight: 4 } as const;
export type Junction = (typeof JUNCTION)[keyof typeof JUNCTION];

/** The values of registers 69 to 72. */
const WAY = { left: 1, right: 2, straight: 3, stop: 4 } as const;
type Way = (typeof WAY)[keyof typeof WAY];

/** Ways that exist at each junction, the first for any other number: chosen. */
const WAYS: Readonly<Record<Exclude<Junction, 0>, readonly Way[]>> = {
  [JUNCTION.crossing]: [WAY.straight, WAY.left, WAY.right, WAY.stop],
  [JUNCTION.tee]: [WAY.left, WAY.right, WAY.stop],
  [JUNCTION.leftOrStraight]: [WAY.straight, WAY.left, WAY.stop],
  [JUNCTION.rightOrStraight]: [WAY.straight, WAY.right, WAY.stop],
};

/** The ways at each junction before a program chooses: registers 69 to 72. */
export const USUAL_WAYS: readonly Way[] = [WAY.straight, WAY.left, WAY.straight, WAY.straight];

/** Speed by grade, 1 … 5: chosen, so that the middle ones are as fast as usual programs. */
const SPEEDS_MM_PER_S = [80, 120, 160, 200, 250] as const;
const TURN_MM_PER_S = 80;

/** From the first sight of a branch on: where it decides, and where the axle is at the branch (of a line of 20 mm). */
const LOOK_MM = 30;
const AT_AXLE_MM = 56;
/** It turns at least so far before it looks for the line, and at most so far. */
const LEAST_TURN_MM = rimMm(45);
const MOST_TURN_MM = rimMm(200);
/** Without a line it stops, and a junction is told this long after it was left: chosen. */
const LOST_S = 1;
const TOLD_S = 0.3;

/** The choices of a program. */
export interface PatrolSettings {
  /** 1 … 5; others count as the nearest. */
  readonly grade: number;
  /** At a crossing, a T, a branch to the left, one to the right. */
  readonly ways: readonly number[];
}

/** The phases of a patrol. Lengths are travels of the wheels at which a phase began, in mm. */
type Phase =
  | { readonly is: 'following' }
  /** A branch was seen: straight on, until it can tell the junction. */
  | { readonly is: 'looking'; readonly fromMm: number; readonly left: boolean; readonly right: boolean }
  /** Straight on, until the axle is at the branch. */
  | { readonly is: 'reaching'; readonly fromMm: number; readonly to: Turn }
  /** On the spot, until the line is in the middle. */
  | { readonly is: 'turning'; readonly fromMm: number; readonly to: Turn }
  /** At a junction where it was told to stop. */
  | { readonly is: 'standing' };

type Turn = 'left' | 'right';

/** Follows lines while it is on. */
export class Patrol {
  private phase: Phase | null = null;
  private walker = createLineWalker();
  /** False from a branch on until the side sensors have left it. */
  private isClear = true;
  private lostS = 0;
  private told: Junction = JUNCTION.none;
  /** Time for which the junction is still told. */
  private toldS = 0;

  /** @param sees true if this sensor sees the line */
  constructor(
    private readonly wheels: Wheels,
    private readonly sees: (sensor: LineName) => boolean,
    private readonly settings: () => PatrolSettings,
  ) {}

  /** Follows the line; from a junction at which it stands straight on. */
  start(): void {
    this.phase = { is: 'following' };
    this.walker = createLineWalker();
    this.lostS = 0;
  }

  /** Ends it; the wheels stop. Nothing happens while it is off. */
  stop(): void {
    if (this.phase === null) return;
    this.phase = null;
    this.wheels.turn(0, 0);
  }

  /** Ends it; the wheels are somebody else's. */
  drop(): void {
    this.phase = null;
  }

  isOn(): boolean {
    return this.phase !== null;
  }

  /** The junction that it is at, or that it left a moment ago. */
  junction(): Junction {
    return this.told;
  }

  /** Call it after each step of the world. */
  step(): void {
    this.tell();
    const { phase } = this;
    if (phase === null) return;
    switch (phase.is) {
      case 'following':
        return this.follow();
      case 'looking':
        return this.look(phase);
      case 'reaching':
        if (this.travelled() - phase.fromMm < AT_AXLE_MM) this.goStraight();
        else this.phase = { is: 'turning', fromMm: this.turned(), to: phase.to };
        return;
      case 'turning':
        return this.turn(phase);
      case 'standing':
        return this.wheels.turn(0, 0);
    }
  }

  private follow(): void {
    const { sees } = this;
    const [left, right, ahead] = [sees('L2'), sees('R2'), this.seesAhead()];
    this.lostS = left || right || ahead ? 0 : this.lostS + STEP_S;
    if (this.lostS >= LOST_S) return this.stop();
    if ((left || right) && this.isClear && ahead) {
      this.isClear = false;
      this.phase = { is: 'looking', fromMm: this.travelled(), left, right };
      return this.goStraight();
    }
    // A side sensor alone has the line where a tight bend has left the others.
    const view = ahead ? { left: sees('L1'), middle: sees('M'), right: sees('R1') } : { left, middle: false, right };
    const pace = this.walker.next(view, this.speed());
    this.wheels.turn(pace.left, pace.right);
  }

  private look(phase: Extract<Phase, { is: 'looking' }>): void {
    const left = phase.left || this.sees('L2');
    const right = phase.right || this.sees('R2');
    this.goStraight();
    if (this.travelled() - phase.fromMm < LOOK_MM) this.phase = { ...phase, left, right };
    else this.decide(left, right, phase.fromMm);
  }

  private decide(left: boolean, right: boolean, fromMm: number): void {
    const junction = junctionOf(left, right, this.seesAhead());
    const corner = left ? WAY.left : WAY.right;
    const way = junction === JUNCTION.none ? corner : wayAt(junction, this.settings().ways);
    this.told = junction;
    this.toldS = TOLD_S;
    if (way === WAY.straight) this.phase = { is: 'following' };
    else if (way === WAY.stop) this.phase = { is: 'standing' };
    else this.phase = { is: 'reaching', fromMm, to: way === WAY.left ? 'left' : 'right' };
  }

  private turn({ fromMm, to }: Extract<Phase, { is: 'turning' }>): void {
    const turned = Math.abs(this.turned() - fromMm);
    if (turned > MOST_TURN_MM) return this.stop();
    if (turned > LEAST_TURN_MM && this.sees('M')) {
      this.start();
      return this.follow();
    }
    if (to === 'left') this.wheels.turn(-TURN_MM_PER_S, TURN_MM_PER_S);
    else this.wheels.turn(TURN_MM_PER_S, -TURN_MM_PER_S);
  }

  /** Tells a junction as long as it is at it, and a moment longer. */
  private tell(): void {
    if (!this.sees('L2') && !this.sees('R2')) this.isClear = true;
    const isAt = this.phase !== null && this.phase.is !== 'following';
    if (isAt || !this.isClear) this.toldS = TOLD_S;
    else this.toldS -= STEP_S;
    if (this.toldS <= 0) this.told = JUNCTION.none;
  }

  private seesAhead(): boolean {
    return this.sees('L1') || this.sees('M') || this.sees('R1');
  }

  private goStraight(): void {
    this.wheels.turn(this.speed(), this.speed());
  }

  private speed(): number {
    const grade = Math.min(Math.max(this.settings().grade, 1), SPEEDS_MM_PER_S.length);
    return SPEEDS_MM_PER_S[grade - 1] ?? 0;
  }

  /** How far it has driven ahead since the start, and how far its rims in turns on the spot, in mm. */
  private travelled(): number {
    return (this.wheels.travelMm(0) + this.wheels.travelMm(1)) / 2;
  }

  private turned(): number {
    return (this.wheels.travelMm(1) - this.wheels.travelMm(0)) / 2;
  }
}

/** The junction with these ways; a corner is none. */
function junctionOf(left: boolean, right: boolean, ahead: boolean): Junction {
  if (left && right) return ahead ? JUNCTION.crossing : JUNCTION.tee;
  if (!ahead) return JUNCTION.none;
  return left ? JUNCTION.leftOrStraight : JUNCTION.rightOrStraight;
}

/** The way that the program has chosen for a junction; if that is none of its ways, the usual one. */
function wayAt(junction: Exclude<Junction, 0>, ways: readonly number[]): Way {
  return WAYS[junction].find((way) => way === ways[junction - 1]) ?? WAYS[junction][0] ?? WAY.stop;
}
