/**
 * The Maqueen Plus V3's own controller: a register machine at I2C address 0x10 (see #devices/i2c-registers). Its registers
 * are numbered in decimals, as in all its drivers:
 *
 *      register  access  meaning
 *      0         RW      left motor direction, 0 forward, 1 backward
 *      1         RW      left motor speed, 0 … 255, takes effect at once and ends what the controller drives by itself
 *      2, 3      RW      right motor
 *      11, 12    RW      left, right lamp: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, others off
 *      29        R       line sensors: bit 0 = R2, 1 = R1, 2 = M, 3 = L1, 4 = L2; 1 on black, 0 on light ground
 *      30 … 39   R       brightness of R2, R1, M, L1, L2, two bytes each, low byte first, 0 … 4095
 *      50        R       length of the version text
 *      51 …      R       version text, ASCII; a read that starts here gets all of it, though 60 … have their own meaning
 *      60        RW      mode, bits: 4 go with 1 (patrol along a line) or 2 (measured move); 8 ends the patrol, 16 the move
 *      61        R       junction of the patrol: 0 none, 1 crossing, 2 T, 3 left or straight on, 4 right or straight on
 *      63        RW      speed of the patrol, 1 … 5
 *      64        RW      distance: 2 backward, otherwise forward
 *      65, 66    RW      distance in cm, high byte first
 *      67        RW      angle: 2 to the left, otherwise to the right
 *      68        RW      angle in degrees
 *      69 … 72   RW      way at a crossing, a T, a branch to the left, to the right: 1 left, 2 right, 3 straight on, 4 stop
 *      73        W       1: everything as after switching on; the controller does not answer for a moment
 *      76, 77    R       speed of the left, the right wheel in fifths of a cm/s, without a sign
 *      78 … 81   R       light on the left, on the right, two bytes each, high byte first, 0 … 1023
 *      85, 86    RW      speed of a distance, of an angle; 2 is usual
 *      87        R       1 while a measured move runs
 *      90, 91    RW      distance driven in cm, high byte first; a write to 91 clears it
 *      others            writes are ignored, reads give 0; also the encoders of the V1 (4 … 7), the servos of the K10 board
 *                        (20, 21), and 10, 62 and 88, which change nothing that can be seen
 *
 * A measured move is the distance or the angle, whichever was written last. Every read begins at the register that was named
 * last: `mbrobot_plusV3.py` writes [76, 1] and then reads the speeds, and names 87 once before it asks again and again.
 *
 * Sources: DFRobot/pxt-DFRobot_MaqueenPlus_v20 `maqueenPlusV2.ts` (V2 and V3), Tiger-Jython/Robotics-Libraries
 * `mbrobot_plusV3.py`, DFRobot-Embedded-Software/DFRobot_MaqueenPlusV3_K10 (73, 90, 91), jhautbois/maqueen-plus-v3-micropython
 * (measured: 4 … 7, 64 … 68, 76, 77). Where they contradict each other: docs/hardware/maqueen-plus-v3.md.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';
import type { Rgb } from '#core/rgb';
import { motorsTouched, signedDuty, type Side } from '#devices/dc-motor';
import {
  bitsOf,
  byteOf,
  createRegisterMachine,
  liveRegisters,
  memoryRegisters,
  textRegisters,
  wordRegisters,
  type RegisterPart,
  type Touched,
} from '#devices/i2c-registers';
import { lampColor } from '../lamp-colors';
import { LINE_NAMES, type LineName } from '../maqueen-plus-frame';
import type { Move } from './moves';
import { USUAL_WAYS, type PatrolSettings } from './patrol';

export const CONTROLLER_ADDRESS = 0x10; // DFRobot maqueenPlusV2.ts: I2CADDR

const MOTORS = 0;
const LAMPS = 11;
const LINE_BITS = 29;
const LINE_VALUES = 30;
const VERSION = 50;
const MODE = 60;
const JUNCTION = 61;
const PATROL_SPEED = 63;
const DISTANCE = 64;
const ANGLE = 67;
const WAYS = 69;
const START_ANEW = 73;
const SPEEDS = 76;
const LIGHT = 78;
const GRADES = 85;
const BUSY = 87;
const DRIVEN = 90;

/** Chosen: product number and form of the V2's text (MBT0021-EN-2.1) for MBT0050. The V3's own is not published. */
export const VERSION_TEXT = 'MBT0050-EN-3.0';

/** Bits of the mode: DFRobot maqueenPlusV2.ts. */
const GO = { any: 4, patrol: 1, move: 2 } as const;
const END = { patrol: 8, move: 16 } as const;

const BACKWARD = 2;
const TO_THE_LEFT = 2;
const USUAL_GRADE = 2; // every driver writes 2
const RAW_PER_MM_PER_S = 0.5; // raw / 5 = cm/s: jhautbois, sjh5637

/** The calls with which the controller drives its parts and reads its sensors; lengths of a robot of real size. */
export interface ControllerParts {
  /** Called after each write transfer that touched a motor: duties −1 … 1 from the bytes; `sides` were touched. */
  motors(left: number, right: number, sides: readonly Side[]): void;
  /** Called after each write transfer that touched a lamp, one or both: 0 left, 1 right. */
  lamps(left: Rgb, right: Rgb, touched: Touched): void;
  isBright(sensor: LineName): boolean;
  /** Brightness, 0 … 4095. */
  brightness(sensor: LineName): number;
  startMove(move: Move): void;
  stopMove(): void;
  isMoving(): boolean;
  startPatrol(): void;
  stopPatrol(): void;
  junction(): number;
  speedMmPerS(side: 0 | 1): number;
  /** Light around it, 0 … 1023. */
  light(side: 0 | 1): number;
  drivenMm(): number;
  clearDriven(): void;
  startAnew(): void;
}

/** The controller, and what its registers say about the patrol. */
export interface Controller {
  readonly target: I2cTarget;
  readonly patrol: () => PatrolSettings;
}

/** Makes the controller as it is after switching on; motors and lamps are off. */
export function createController(parts: ControllerParts): Controller {
  let patrol: PatrolSettings = { grade: USUAL_GRADE, ways: USUAL_WAYS };
  const target = createRegisterMachine(
    [
      memoryRegisters(MOTORS, 4, ([dirL = 0, speedL = 0, dirR = 0, speedR = 0], touched) =>
        parts.motors(dutyOf(dirL, speedL), dutyOf(dirR, speedR), motorsTouched(touched)),
      ),
      memoryRegisters(LAMPS, 2, ([left = 0, right = 0], touched) =>
        parts.lamps(lampColor(left), lampColor(right), touched),
      ),
      ...senseRegisters(parts),
      textRegisters(VERSION, VERSION_TEXT, MODE - VERSION),
      ...modeRegisters(parts),
      liveRegisters(JUNCTION, 1, () => parts.junction()),
      memoryRegisters(
        PATROL_SPEED,
        1,
        ([grade = 0]) => {
          patrol = { ...patrol, grade };
        },
        [patrol.grade],
      ),
      memoryRegisters(
        WAYS,
        4,
        (ways) => {
          patrol = { ...patrol, ways: [...ways] };
        },
        patrol.ways,
      ),
      memoryRegisters(START_ANEW, 1, ([byte]) => {
        if (byte === 1) parts.startAnew();
      }),
    ],
    { staysSelected: true },
  );
  return { target, patrol: () => patrol };
}

/** Line, speed, light, distance driven. */
function senseRegisters(parts: ControllerParts): readonly RegisterPart[] {
  return [
    liveRegisters(LINE_BITS, 1, () => bitsOf(LINE_NAMES, (name) => !parts.isBright(name))),
    wordRegisters(LINE_VALUES, LINE_NAMES.length, 'low-first', (word) => {
      const name = LINE_NAMES[word];
      return name === undefined ? 0 : parts.brightness(name);
    }),
    liveRegisters(SPEEDS, 2, (offset) => {
      const speed = Math.abs(parts.speedMmPerS(offset === 0 ? 0 : 1));
      return Math.min(Math.round(speed * RAW_PER_MM_PER_S), 0xff);
    }),
    wordRegisters(LIGHT, 2, 'high-first', (word) => parts.light(word === 0 ? 0 : 1)),
    {
      first: DRIVEN,
      count: 2,
      read: (offset) => byteOf(Math.round(parts.drivenMm() / 10), offset),
      write: (offset) => {
        if (offset === 1) parts.clearDriven();
      },
    },
  ];
}

/** The mode, and the measured move that it starts. */
function modeRegisters(parts: ControllerParts): readonly RegisterPart[] {
  let [distanceGrade, angleGrade] = [USUAL_GRADE, USUAL_GRADE];
  let moveOf: (() => Move) | null = null;
  return [
    memoryRegisters(MODE, 1, ([mode = 0]) => {
      if ((mode & END.patrol) !== 0) parts.stopPatrol();
      if ((mode & END.move) !== 0) parts.stopMove();
      if ((mode & GO.any) === 0) return;
      if ((mode & GO.patrol) !== 0) parts.startPatrol();
      else if ((mode & GO.move) !== 0 && moveOf !== null) parts.startMove(moveOf());
    }),
    memoryRegisters(DISTANCE, 3, ([direction, high = 0, low = 0]) => {
      const way = { kind: 'distance', isForward: direction !== BACKWARD, cm: high * 256 + low } as const;
      moveOf = () => ({ ...way, grade: distanceGrade });
    }),
    memoryRegisters(ANGLE, 2, ([direction, deg = 0]) => {
      const way = { kind: 'angle', isToTheRight: direction !== TO_THE_LEFT, deg } as const;
      moveOf = () => ({ ...way, grade: angleGrade });
    }),
    memoryRegisters(
      GRADES,
      2,
      ([distance = 0, angle = 0]) => {
        distanceGrade = distance;
        angleGrade = angle;
      },
      [USUAL_GRADE, USUAL_GRADE],
    ),
    liveRegisters(BUSY, 1, () => (parts.isMoving() ? 1 : 0)),
  ];
}

/** The duty of a motor; 0 for directions that it does not know: chosen, as owners of a V2 saw it. */
const dutyOf = (direction: number, speed: number): number => (direction > 1 ? 0 : signedDuty(direction, speed));
