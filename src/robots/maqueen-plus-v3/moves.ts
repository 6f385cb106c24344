/**
 * Measured moves of the Maqueen Plus V3: its controller drives a distance or turns on the spot by an angle and counts the
 * turns of its wheels. Published are the registers, and figures of owners: 100 cm within 10 s, 180° within 5 s, both a
 * little off (docs/hardware/maqueen-plus-v3.md). Ramps and speeds are chosen after them.
 */
import { radOf } from '#core/angle';
import { STEP_S } from '#world/step';
import { PLUS_TRACK_MM } from '../maqueen-plus-frame';
import type { Wheels } from './wheels';

/** A move as the registers have it. Grades: 1 slow, 2 as all drivers use it, up to 10. */
export type Move =
  | { readonly kind: 'distance'; readonly isForward: boolean; readonly cm: number; readonly grade: number }
  | { readonly kind: 'angle'; readonly isToTheRight: boolean; readonly deg: number; readonly grade: number };

/** Speeds per grade; grade 2 is 135 mm/s and 45° per second: chosen. */
const MM_PER_S = 67.5;
const DEG_PER_S = 22.5;
/** As fast as the usual motors keep straight with what the battery leaves them: chosen. */
const MOST_MM_PER_S = 250;
const RAMP_S = 0.2;

/** Standard deviations of where a move ends. jhautbois/maqueen-plus-v3-micropython measured ±1 cm and ±5°: chosen within. */
const MISS_MM = 4;
const MISS_DEG = 2;

/** Near its end a move slows down in proportion to what is left, so that it does not run over: per second, chosen. */
const APPROACH_PER_S = 12;
/** A move is done this near to its end: chosen, 0.014° of a turn. */
const DONE_MM = 0.01;
/** It is done as well where a weak motor stands still so near to its end, on wheels slower than this: chosen, 1.4° of a turn. */
const GIVEN_UP_MM = 1;
const STANDS_MM_PER_S = 0.05;
/** How hard a wheel that is ahead waits for the other: per second, chosen. */
const TOGETHER_PER_S = 8;

/** Drives moves. */
export interface Mover {
  start(move: Move): void;
  /** Breaks off; the wheels stop. Nothing happens while no move runs. */
  stop(): void;
  /** Forgets the move; the wheels are somebody else's. */
  drop(): void;
  isMoving(): boolean;
  /** Call it after each step of the world. */
  step(): void;
}

/** The way of the rims in a move. */
interface Way {
  readonly lengthMm: number;
  readonly mmPerS: number;
  readonly left: 1 | -1;
  readonly right: 1 | -1;
}

/** @param miss how far a move that starts now misses its end, in standard deviations */
export function createMover(wheels: Wheels, miss: () => number): Mover {
  let running: { readonly way: Way; readonly left: number; readonly right: number; speed: number } | null = null;
  const stop = (): void => {
    if (running === null) return;
    running = null;
    wheels.turn(0, 0);
  };
  return {
    start: (move) => {
      running = { way: wayOf(move, miss()), left: wheels.travelMm(0), right: wheels.travelMm(1), speed: 0 };
    },
    stop,
    drop: () => {
      running = null;
    },
    isMoving: () => running !== null,
    step: () => {
      if (running === null) return;
      const { way } = running;
      const left = way.left * (wheels.travelMm(0) - running.left);
      const right = way.right * (wheels.travelMm(1) - running.right);
      const done = (left + right) / 2;
      const rest = way.lengthMm - done;
      if (rest < DONE_MM || (rest < GIVEN_UP_MM && stands(wheels))) return stop();
      const ramp = way.mmPerS / RAMP_S;
      running.speed = Math.min(running.speed + ramp * STEP_S, way.mmPerS);
      const speed = Math.min(running.speed, Math.sqrt(2 * ramp * rest), APPROACH_PER_S * rest);
      const aligned = (TOGETHER_PER_S * (right - left)) / 2;
      wheels.turn(way.left * (speed + aligned), way.right * (speed - aligned));
    },
  };
}

const stands = (wheels: Wheels): boolean =>
  Math.abs(wheels.speedMmPerS(0)) < STANDS_MM_PER_S && Math.abs(wheels.speedMmPerS(1)) < STANDS_MM_PER_S;

function wayOf(move: Move, misses: number): Way {
  const grade = Math.max(move.grade, 1);
  if (move.kind === 'distance') {
    const mmPerS = Math.min(MM_PER_S * grade, MOST_MM_PER_S);
    const lengthMm = move.cm === 0 ? 0 : 10 * move.cm + MISS_MM * misses;
    return move.isForward ? { lengthMm, mmPerS, left: 1, right: 1 } : { lengthMm, mmPerS, left: -1, right: -1 };
  }
  const mmPerS = Math.min(rimMm(DEG_PER_S * grade), MOST_MM_PER_S);
  const lengthMm = move.deg === 0 ? 0 : rimMm(move.deg + MISS_DEG * misses);
  return move.isToTheRight ? { lengthMm, mmPerS, left: 1, right: -1 } : { lengthMm, mmPerS, left: -1, right: 1 };
}

/** How far the rims go for a turn on the spot by this angle. */
export const rimMm = (deg: number): number => (radOf(deg) * PLUS_TRACK_MM) / 2;
