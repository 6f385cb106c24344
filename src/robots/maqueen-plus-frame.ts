/**
 * The frame that the Maqueen Plus V2 and V3 share: outline, wheels, line sensors. Frame of reference and units: see robot.ts;
 * NOE = NoeSchaller/TS_Maqueen (its Maqueen Plus is the V1, of the same shape), GBSL = GBSL-Informatik/maqueen-plus-v2-mpy.
 */
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import type { LinePlace } from './line-row';
import { wheelPair } from './wheels';

/** Distance between the middles of the wheels: Tiger-Jython/Aplu-Libraries and jhautbois/maqueen-plus-v3-micropython. */
export const PLUS_TRACK_MM = 82;

/** Diameter 43: MINTspark/pxt-mintspark-drivemaqueenplusv2, jhautbois. */
const WHEEL_RADIUS_MM = 21.5;
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen, as for the Lite

/** Outline: NOE's polygon with the axle 27 mm behind its middle, narrowed between the wheels, which are 9 mm wide (NOE). */
const FRONT: readonly Vec[] = [
  { x: 78.5, y: -23 },
  { x: 78.5, y: 23 },
  { x: 43.5, y: 50 },
  { x: 24, y: 50 },
  { x: 24, y: -50 },
  { x: 43.5, y: -50 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 24, y: -35 },
  { x: 24, y: 35 },
  { x: 21.5, y: 45.5 },
  { x: -21.5, y: 45.5 },
  { x: -24.5, y: 35 },
  { x: -24.5, y: -35 },
  { x: -21.5, y: -45.5 },
  { x: 21.5, y: -45.5 },
];

/** The parts of the body that both have. */
export const plusFrame = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  centreOfMassMm: { x: 12, y: 0 }, // between axle and castor, near the axle, as the cell lies behind it: chosen
  wheels: wheelPair(PLUS_TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 46, y: 0 }, // chosen: behind the middle line sensor
} as const satisfies Partial<ChassisType>;

/** Middle of the front edge. */
export const PLUS_MOUNT_MM: Vec = { x: 78.5, y: 0 };

/** The line sensors from right to left: the order of their bits and values in both controllers. */
export const LINE_NAMES = ['R2', 'R1', 'M', 'L1', 'L2'] as const;

/** A line sensor's name, as printed on the robot. */
export type LineName = (typeof LINE_NAMES)[number];

/**
 * A row of three in front of the castor, the outer two further back near the wheels, as GBSL draws them; the figures
 * are chosen: a line of 20 mm width covers M alone, and the outer two see a crossing line after the others.
 */
export const PLUS_LINE_SENSORS: readonly LinePlace<LineName>[] = [
  { name: 'L2', atMm: { x: 46, y: 36 } },
  { name: 'L1', atMm: { x: 56, y: 12 } },
  { name: 'M', atMm: { x: 56, y: 0 } },
  { name: 'R1', atMm: { x: 56, y: -12 } },
  { name: 'R2', atMm: { x: 46, y: -36 } },
];

/** Chosen, as for the Lite: a reflective sensor sees a spot as wide as its housing. */
export const PLUS_LINE_SPOT_RADIUS_MM = 2.5;
