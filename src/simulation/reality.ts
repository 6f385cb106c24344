/**
 * *Reality*: how much a robot resembles a school's used one, 0 (ideal) … 1. Everything comes from the seed: the same
 * seed gives the same robot with the same faults.
 *
 *      motors       one is stronger than the other, so that `forward()` drifts and `calibrate` has a purpose
 *      battery      not quite full, and weaker while the motors pull
 *      line         each sensor sees a little lighter or darker than the others, and its reading trembles
 *      ultrasonic   trembles and misses an echo now and then. From slanted walls it hears as the robot's option says
 *      lidar        trembles, far things more; now and then a cell loses a shiny floor
 *      camera       the places and sizes of what it finds tremble by a few pixels, anew in each picture
 *      moves        those that a robot measures by itself end a little too early or too late
 *
 * A robot that was measured (`#robots/traits`) brings motors, battery and sensors of its own; chance then only lets its
 * sensors tremble.
 *
 * A measurement is a function of its moment, not of the number of readings: an additional snapshot changes nothing.
 */
import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import { HUSKYLENS_PICTURE, HUSKYLENS_PICTURE_US, type HuskyResult } from '#devices/huskylens';
import { bodyWith, supplyOf, type MotorTraits, type Traits } from '#robots/traits';
import type { ChassisType } from '#world/chassis';
import type { DepthCell } from '#world/probes/depth-grid';
import type { ConeHit } from '#world/probes/distance-cone';
import type { Shares } from '#world/shapes';
import { STEP_US } from '#world/step';

/** A robot's faults. */
export interface Reality {
  /** The body with unequal motors. */
  body(type: ChassisType): ChassisType;
  /** The battery's voltage compared with a full one while the motors run at these duties, 0 … 1. */
  supply(duty: { readonly left: number; readonly right: number }): number;
  /** Distorts a reflectance of 0 … 1 for the line sensor at `spot`. @param us moment at which it looked; left out: now */
  reflectance(seen: number, spot: Vec, us?: number): number;
  /** Distorts the reading of the ultrasonic sensor. */
  echo(hit: ConeHit): ConeHit;
  /** Distorts the picture of the lidar. */
  depths(cells: readonly DepthCell[]): readonly DepthCell[];
  /** Distorts the light that a colour sensor gets. */
  light(seen: Shares): Shares;
  /** Distorts what a camera found in its picture. */
  seen(results: readonly HuskyResult[]): readonly HuskyResult[];
  /** How far a move that the robot measures by itself misses its end now, in standard deviations. */
  miss(): number;
}

/** A full battery's voltage in mV. Chosen: four NiMH cells of 1.2 V. */
export const FULL_MV = 4800;

// At reality 1. All chosen: after teachers' reports of a drawer of school robots, large enough to be seen, small enough
// that a program with feedback still succeeds.
const MOTOR_DIFFERENCE = { least: 0.03, most: 0.06 }; // share by which one motor is stronger and the other weaker: 15 to 30 cm off after 1 m
const FLAT_BATTERY = 0.12; // the emptiest battery that still drives
const SAG_AT_FULL_DUTY = 0.08; // both motors at full duty
const SENSOR_OFFSET = 0.08; // reflectance
const SENSOR_NOISE = 0.06;
const ECHO_NOISE_MM = 4;
const ECHO_NOISE_SHARE = 0.01;
const MISSED_ECHOES = 0.02;
// sjh5637/myMaqueenPlusV3_extension measured jumps of 80 to 95 mm between pictures at 0.7 to 1.5 m, and that 8 of 10
// pictures of a shiny floor lost it; a matt one loses nothing. Here a floor in between.
const DEPTH_NOISE = { leastMm: 7, share: 0.026 }; // largest; as a standard deviation 4 mm and 1.5 %
const MISSED_FLOOR = 0.4;
const LIGHT_NOISE = 0.02; // largest; as a standard deviation about 1 %

const PICTURE_NOISE_PX = 3; // largest, of 320: what stands still jumps by a pixel or two from picture to picture

/** The robot as built. */
const IDEAL: Reality = {
  body: (type) => type,
  supply: () => 1,
  reflectance: (seen) => seen,
  echo: (hit) => hit,
  depths: (cells) => cells,
  light: (seen) => seen,
  seen: (results) => results,
  miss: () => 0,
};

/**
 * @param amount 0 … 1
 * @param nowUs simulated time
 * @param own what was measured of this robot; left out: its faults come from the seed
 */
export function createReality(amount: number, seed: number, nowUs: () => number, own?: Traits): Reality {
  if (amount === 0) return own === undefined ? IDEAL : measured(own, IDEAL);
  const { motors, salt } = drawn(amount, seed);
  const offset = own === undefined ? SENSOR_OFFSET : 0;
  const senses = trembling(amount, salt, nowUs, offset);
  if (own !== undefined) return measured(own, senses);
  return {
    ...senses,
    body: (type) => bodyWith(type, motors),
    supply: ({ left, right }) => supplyOf(motors, left, right),
  };
}

/** Everything that the seed draws before the run. */
function drawn(amount: number, seed: number): { readonly motors: MotorTraits; readonly salt: number } {
  const chance = createRng(seed).fork('reality');
  const { least, most } = MOTOR_DIFFERENCE;
  const sign = chance.unit() < 0.5 ? -1 : 1;
  const difference = sign * amount * (least + (most - least) * chance.unit());
  const charge = 1 - amount * FLAT_BATTERY * chance.unit();
  return { motors: { difference, charge, sag: amount * SAG_AT_FULL_DUTY, friction: 0 }, salt: chance.u32() };
}

/** The lasting faults of a robot that was not measured: all that tells it from others of its type. */
export interface Faults {
  readonly motors: MotorTraits;
  /** How much lighter than it is the line sensor at a spot sees the floor, in reflectance; below 0: darker. */
  readonly lighter: (spot: Vec) => number;
}

/** The faults that the robot of a seed has for good. @param amount 0 … 1 */
export function faultsOf(amount: number, seed: number): Faults {
  const { motors, salt } = drawn(amount, seed);
  return { motors, lighter: (spot) => amount * SENSOR_OFFSET * sideOf(salt, channelOf(spot)) };
}

/** The share of the largest offset that the sensor of a channel has, −1 … 1. */
const sideOf = (salt: number, channel: number): number => 2 * unitOf(salt, -1, channel) - 1;

type Senses = Pick<Reality, 'reflectance' | 'echo' | 'depths' | 'light' | 'seen' | 'miss'>;

/** A measured robot whose sensors tremble like these. */
function measured({ motors, ultrasonic }: Traits, senses: Senses): Reality {
  return {
    ...senses,
    body: (type) => bodyWith(type, motors),
    supply: ({ left, right }) => supplyOf(motors, left, right),
    echo: (hit) => {
      const distanceMm = Math.max(ultrasonic.offsetMm + ultrasonic.scale * hit.distanceMm, 0);
      return senses.echo({ ...hit, distanceMm });
    },
  };
}

/** Sensors that tremble; each line sensor sees up to `mostOffset` lighter or darker than the others. */
function trembling(amount: number, salt: number, nowUs: () => number, mostOffset: number): Senses {
  const moment = (us = nowUs()): number => Math.floor(us / STEP_US);
  const tremble = (channel: number, at = moment()): number => 2 * unitOf(salt, at, channel) - 1;
  return {
    reflectance: (seen, spot, us) => {
      const channel = channelOf(spot);
      const offset = mostOffset * sideOf(salt, channel);
      const most = Math.max(1, seen);
      return Math.min(Math.max(seen + amount * (offset + SENSOR_NOISE * tremble(channel, moment(us))), 0), most);
    },
    echo: (hit) => {
      if (hit.distanceMm === Infinity) return hit;
      if (unitOf(salt, moment(), ECHO_MISSED) < amount * MISSED_ECHOES) return { distanceMm: Infinity, hitMm: null };
      const noiseMm = (ECHO_NOISE_MM + ECHO_NOISE_SHARE * hit.distanceMm) * tremble(ECHO);
      return { ...hit, distanceMm: Math.max(hit.distanceMm + amount * noiseMm, 0) };
    },
    depths: (cells) => {
      const picture = Math.floor(nowUs() / LIDAR_PICTURE_US);
      return cells.map((cell, place) => {
        const channel = DEPTHS + 2 * place;
        if (cell.depthMm === Infinity) return cell;
        if (cell.isFloor && unitOf(salt, picture, channel + 1) < amount * MISSED_FLOOR) return LOST;
        const noiseMm = Math.max(DEPTH_NOISE.leastMm, DEPTH_NOISE.share * cell.depthMm) * tremble(channel, picture);
        return { ...cell, depthMm: Math.max(cell.depthMm + amount * noiseMm, 0) };
      });
    },
    light: (seen) => {
      const share = (i: number, value: number): number => value * (1 + amount * LIGHT_NOISE * tremble(LIGHT + i));
      return [share(0, seen[0]), share(1, seen[1]), share(2, seen[2])];
    },
    seen: (results) => {
      const picture = Math.floor(nowUs() / HUSKYLENS_PICTURE_US);
      return results.map((one, place) => {
        const off = (axis: number): number =>
          Math.round(amount * PICTURE_NOISE_PX * tremble(SEEN + 4 * place + axis, picture));
        if (one.kind === 'arrow') return { ...one, tail: moved(one.tail, [off(0), off(1)]), head: moved(one.head, [off(2), off(3)]) }; // prettier-ignore
        const [x, y] = moved([one.x, one.y], [off(0), off(1)]);
        return { ...one, x, y, width: Math.max(one.width + off(2), 1), height: Math.max(one.height + off(3), 1) };
      });
    },
    miss: () => amount * bellOf((draw) => unitOf(salt, moment(), MISS + draw)),
  };
}

const ECHO = 1;
const ECHO_MISSED = 2;
/** A lidar trembles anew with each picture that it takes: 15 a second (DFRobot SEN0628 with 8 × 8 cells). */
const LIDAR_PICTURE_US = 66_667;
/** The first of those of the lidar's cells; channels of line sensors are whole numbers that never come near it. */
const DEPTHS = 0x40000000;

/** The first of those of measured moves, likewise. */
const MISS = 0x50000000;
const BELL_DRAWS = 12;

/** The first of those of colours, likewise. */
const LIGHT = 0x60000000;

/** The first of those of what a camera finds, likewise. */
const SEEN = 0x70000000;

/** A place in a camera's picture, moved, but not out of it. */
const moved = ([x, y]: PicturePoint, [dx, dy]: PicturePoint): PicturePoint => [
  Math.min(Math.max(x + dx, 0), HUSKYLENS_PICTURE.width - 1),
  Math.min(Math.max(y + dy, 0), HUSKYLENS_PICTURE.height - 1),
];
type PicturePoint = readonly [x: number, y: number];

/** A number with mean 0 and standard deviation 1, within ±6: the sum of twelve even ones (Irwin and Hall). */
function bellOf(unit: (draw: number) => number): number {
  let sum = -BELL_DRAWS / 2;
  for (let draw = 0; draw < BELL_DRAWS; draw++) sum += unit(draw);
  return sum;
}

const LOST: DepthCell = { depthMm: Infinity, isFloor: false };

/** A different number for each place of a sensor. */
const channelOf = ({ x, y }: Vec): number => Math.round(x * 10) * 4096 + Math.round(y * 10) + 3;

/** A number from 0 up to 1 that depends only on these: the finalizer of MurmurHash3 (Austin Appleby), twice. */
function unitOf(salt: number, moment: number, channel: number): number {
  return mixed(mixed(salt ^ moment) ^ channel) / 4294967296;
}

function mixed(value: number): number {
  let hash = value | 0;
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return (hash ^ (hash >>> 16)) >>> 0;
}
