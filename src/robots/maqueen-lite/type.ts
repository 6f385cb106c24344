/**
 * DFRobot Maqueen Lite (micro:Maqueen V4): its body. Frame and units: see ../robot.ts. Where each number comes from:
 * SOURCES.md; NOE = NoeSchaller/TS_Maqueen, ETH = Tiger-Jython/Robotics-Libraries.
 */
import { attachmentOptions } from '#attachments/options';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import { cameraOption } from '../camera-options';
import { colourOptions } from '../colour-options';
import { echoOption } from '../echo';
import { incidenceOption } from '../incidence';
import type { RobotType } from '../robot';
import { wheelPair } from '../wheels';

/** Ports of the two servos. */
export const SERVO_PORTS = ['S1', 'S2'] as const;

/** Distance between the middles of the wheels: ETH mbrobot.py (half the axle is 3.5 cm) and NOE (wheels at ±35). */
const TRACK_MM = 70;
const WHEEL_RADIUS_MM = 21.5; // diameter 43: NOE
const GRIP_MU = 0.8; // rubber on a smooth floor: chosen; only pushing and stalling depend on it

/** Outline: NOE's polygon with the axle 18 mm behind its middle, made symmetrical; the wheels are 9 mm wide (NOE). */
const FRONT: readonly Vec[] = [
  { x: 58, y: -21 },
  { x: 58, y: 21 },
  { x: 43, y: 40 },
  { x: 26, y: 40 },
  { x: 26, y: -40 },
  { x: 43, y: -40 },
];
const REAR_WITH_WHEELS: readonly Vec[] = [
  { x: 26, y: -29 },
  { x: 26, y: 29 },
  { x: 21.5, y: 39.5 },
  { x: -21.5, y: 39.5 },
  { x: -22, y: 29 },
  { x: -22, y: -29 },
  { x: -21.5, y: -39.5 },
  { x: 21.5, y: -39.5 },
];

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  heightMm: 85, // chosen, to the top of the upright micro:bit
  massG: 130, // chosen, not weighed: about 75 g kit, 9 g micro:bit, 46 g for three AAA cells with their holder
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: wheelPair(TRACK_MM, { radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU }),
  castorMm: { x: 46, y: 0 }, // chosen: between line sensors and front edge
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/maqueen-lite-motor-law.md
    v0MmPerS: 423,
    coulomb: 0.0196,
    breakaway: { share: 0.0079, until: 0.2966 },
    viscous: 0.1467,
    yawResistance: 0.1123,
    stallForceN: 1, // chosen: computed to push two 40 g blocks at byte 39; at full power the tyres slip first
    // chosen: that is 0.13 s at the usual speed of 50, where the short pulses pull little; with twice as much, the line
    // follower of courses/closed-line loses the line in curves of 15 cm
    lagS: 0.03,
  },
};

export const maqueenLite: RobotType = {
  id: 'maqueen-lite',
  name: 'Maqueen Lite',
  place: 1,
  board: 'microbit-v2',
  body,
  modules: ['mbrobot', 'mbrobotmot', 'mbalarm'],
  driverNames: ['maqueen', 'maqueenlite'],
  options: [...attachmentOptions(SERVO_PORTS), echoOption, incidenceOption, ...colourOptions, cameraOption],
  mountMm: { x: 58, y: 0 },
};
