/**
 * DFRobot Maqueen Lite (micro:Maqueen V4). Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * NOE = NoeSchaller/TS_Maqueen, ETH = Tiger-Jython/Robotics-Libraries, DF = DFRobot pxt-maqueen.
 *
 *      P0  buzzer              P8   red LED left       I2C 0x10  motors, servos S1 S2, version
 *      P1  ultrasonic trigger  P12  red LED right
 *      P2  ultrasonic echo     P13  line sensor left
 *      P15 four RGB LEDs       P14  line sensor right
 */
import type { Vec } from '#core/geometry';
import { signedDuty } from '#devices/dc-motor';
import { attachHcSr04, FARTHEST_MM } from '#devices/hc-sr04';
import { ledOn } from '#devices/led';
import { attachLineSensor } from '#devices/line-sensor';
import { attachWs2812 } from '#devices/ws2812';
import type { ChassisType } from '#world/chassis';
import { STEP_US } from '#world/step';
import type { Cone } from '#world/world';
import type { Robot, RobotContext, RobotState, RobotType, UltrasonicState } from '../robot';
import { CONTROLLER_ADDRESS, createController } from './controller';
import drawing from './robot.svg?raw';
import firstDrive from './examples/first_drive.py?raw';
import lights from './examples/lights.py?raw';
import square from './examples/square.py?raw';
import mbalarm from './library/mbalarm.py?raw';
import mbrobot from './library/mbrobot.py?raw';
import mbrobotmot from './library/mbrobotmot.py?raw';

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
  massG: 130, // chosen, not weighed: about 75 g kit, 9 g micro:bit, 46 g for three AAA cells with their holder
  centreOfMassMm: { x: 8, y: 0 }, // between axle and castor, near the axle: chosen
  wheels: [
    { atMm: { x: 0, y: TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
    { atMm: { x: 0, y: -TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
  ],
  castorMm: { x: 46, y: 0 }, // chosen: between line sensors and front edge
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/maqueen-lite-motor-law.md
    v0MmPerS: 401,
    coulomb: 0.0285,
    viscous: 0.106,
    yawResistance: 0.0414,
    stallForceN: 1, // chosen: computed to push two 40 g blocks at byte 39; at full power the tyres slip first
    // chosen: that is 0.13 s at the usual speed of 50, where the short pulses pull little; with twice as much the
    // line follower of courses/closed-line loses the line in curves of 15 cm
    lagS: 0.03,
  },
};

const LINE_LEFT: Vec = { x: 34, y: 7 }; // NOE
const LINE_RIGHT: Vec = { x: 34, y: -7 }; // NOE
const LINE_SPOT_RADIUS_MM = 2.5; // chosen: the usual reflective sensor sees a spot as wide as its housing, 5 mm

/** NOE draws the sensor 53 mm ahead of the axle, the body ends at 58: chosen in between, where the two cans end. */
const SONAR_AT: Vec = { x: 55, y: 0 };
const SONAR_CONE: Cone = {
  openingRad: Math.PI / 9, // 20°: beam of TigerJython's own simulator, Tiger-Jython/Aplu-Libraries
  rangeMm: FARTHEST_MM,
};

const RGB_COUNT = 4; // front left, back left, back right, front right: ETH mbrobot.py
const SERVO_MAX_DEG = 180; // ETH mbrobot.py setServo: 0 … 180

export const maqueenLite: RobotType = {
  id: 'maqueen-lite',
  name: 'Maqueen Lite',
  board: 'microbit-v2',
  body,
  libraries: { 'mbrobot.py': mbrobot, 'mbrobotmot.py': mbrobotmot, 'mbalarm.py': mbalarm },
  examples: [
    { file: 'first_drive.py', title: { de: 'Erste Fahrt', en: 'First drive' }, source: firstDrive },
    { file: 'square.py', title: { de: 'Ein Quadrat fahren', en: 'Drive a square' }, source: square },
    { file: 'lights.py', title: { de: 'Lichter', en: 'Lights' }, source: lights },
  ],
  drawing,
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, chassis, clock, scale } = context;
  const servos: Record<string, number> = {};
  const duty = { left: 0, right: 0 };
  const drive = (left: number, right: number): void => {
    duty.left = left;
    duty.right = right;
    chassis.setDuty(0, left);
    chassis.setDuty(1, right);
  };
  const controller = createController({
    motors: (left, right) => drive(signedDuty(left.direction, left.speed), signedDuty(right.direction, right.speed)),
    servo: (port, angleDeg) => {
      servos[port] = Math.min(angleDeg, SERVO_MAX_DEG);
    },
  });
  const facing = () => context.distance(scaled(SONAR_AT, scale), 0, SONAR_CONE);
  const see = (spot: Vec) => (): number => context.ground(scaled(spot, scale), LINE_SPOT_RADIUS_MM * scale);

  const lineLeft = attachLineSensor(board.wire('P13'), see(LINE_LEFT));
  const lineRight = attachLineSensor(board.wire('P14'), see(LINE_RIGHT));
  const underglow = attachWs2812(board.wire('P15'), RGB_COUNT);
  const leds = { left: ledOn(board.wire('P8')), right: ledOn(board.wire('P12')) };
  const stops = [
    board.i2c.attach(CONTROLLER_ADDRESS, controller),
    attachHcSr04(clock, { trigger: board.wire('P1'), echo: board.wire('P2') }, () => facing().distanceMm),
    clock.every(STEP_US, () => {
      lineLeft.sample();
      lineRight.sample();
    }),
    lineLeft.stop,
    lineRight.stop,
    underglow.stop,
    () => drive(0, 0),
  ];

  const state = (): RobotState => ({
    leds: { left: leds.left.isLit(), right: leds.right.isLit() },
    rgb: underglow.colors(),
    lineSensors: [
      { name: 'left', atMm: LINE_LEFT, bright: lineLeft.isBright() },
      { name: 'right', atMm: LINE_RIGHT, bright: lineRight.isBright() },
    ],
    servos: { ...servos },
    duty: { ...duty },
    ultrasonic: beam(context, facing()),
  });
  return { state, detach: () => stops.forEach((stop) => stop()) };
}

function beam(context: RobotContext, hit: ReturnType<RobotContext['distance']>): UltrasonicState {
  return {
    fromMm: context.chassis.toWorld(scaled(SONAR_AT, context.scale)),
    headingRad: context.chassis.pose().headingRad,
    openingRad: SONAR_CONE.openingRad,
    distanceMm: hit.distanceMm === Infinity ? null : hit.distanceMm,
    hitMm: hit.hitMm,
  };
}

const scaled = (point: Vec, scale: number): Vec => ({ x: point.x * scale, y: point.y * scale });
