/**
 * Additions of the Maqueen V5 to the controller. Its registers are at addresses that are empty on earlier robots, so
 * one Maqueen Lite stands for all of them: a program for the V5 finds its registers, a program for the V3 or V4 never
 * notices them.
 *
 *      register      access  meaning
 *      0x0B, 0x0C    RW      colour of the left, right car light: 1 red … 7 white, 8 or 0 off
 *      0x0D, 0x0F    RW      number of flashes of the left, right one
 *      0x0E, 0x10    RW      how fast: 1 … 5
 *      0x11, 0x12    RW      the left, right one runs through the colours: 1 … 5
 *      0x1D          R       line sensors: bit 2 left, bit 1 middle, bit 0 right; 1 on black
 *      0x1E … 0x27   R       five ADC channels, two bytes each, high byte first: the second left, the third middle, the
 *                            fourth right; the others 0
 *      0x29 … 0x2C   R       light on the left, on the right, two bytes each, high byte first
 *      0x2D          RW      kind of cells: 0 lithium, 1 alkaline
 *      0x2E          R       their charge, 0 … 100 %
 *      0x46          W       restart: lights and line following off
 *      0x47          RW      line following by itself: 1 on, 0 off
 *      0x48          RW      its speed, 1 … 3
 *
 * Sources: DFRobot pxt-maqueen `maqueen.ts`, namespace Maqueen_V5; humpda/maqueenliteV5_micropython `mbrobotv5.py`. For
 * values in neither of them see SOURCES.md.
 */
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import { BOTH_SIDES } from '#devices/dc-motor';
import { bitsOf, liveRegisters, memoryRegisters, wordRegisters, type RegisterPart } from '#devices/i2c-registers';
import type { Motors } from '../mounting';
import { lightEyes, type LightEye } from '../light-eyes';
import { createLineWalker } from '../line-walking';
import { mountLineRow, type LineRow } from '../line-row';
import type { OnSet, RobotContext } from '../robot';
import { createCarLight, type CarLight } from './car-light';

const CAR_LIGHTS = 0x0b;
const LINE_BITS = 0x1d;
const LINE_VALUES = 0x1e;
const LIGHT = 0x29;
const BATTERY_KIND = 0x2d;
const BATTERY = 0x2e;
const START_ANEW = 0x46;
const LINE_WALKING = 0x47;

type LineName = 'left' | 'middle' | 'right';

/** Bits from 0 on: DFRobot, readPatrol. */
const BITS: readonly LineName[] = ['right', 'middle', 'left'];
/** ADC channels: DFRobot, readPatrolData. */
const CHANNELS: readonly (LineName | null)[] = [null, 'left', 'middle', 'right', null];

/** Chosen: as on the Maqueen Plus V1, also 12 bits; a public program takes 1000 … 4095 as a sign of a V5. */
const BRIGHTNESS = { black: 1000, floor: 3500, most: 4095 } as const;

/** Chosen: 12 bits again; a torch reads 2040, because public programs turn to a light from a sum of 3000 on. */
const LIGHT_PER_LEVEL = 8;

/** Chosen: near the front edge, 60 mm apart. */
const LIGHT_EYES = lightEyes({ x: 48, y: 30 });

/**
 * Voltages of full and empty cells, in mV, by kind: chosen, one lithium cell behind a converter, three alkaline cells.
 */
const CELLS_MV = [
  { empty: 3300, full: 4200 },
  { empty: 3300, full: 4500 },
] as const;

/** Speed byte of a wheel that follows the line, by grade, 1 … 3: chosen. Other grades drive like the first. */
const WALKING_SPEEDS = [40, 40, 55, 70] as const;

const FULL_BYTE = 255;

/** The V5's parts on one robot. */
export interface V5 {
  readonly registers: readonly RegisterPart[];
  isLit(side: 0 | 1): boolean;
  /** Call it after each step of the world. */
  step(): void;
  /** Call it when the robot goes. */
  readonly stop: Stop;
}

/** Places and spot sizes of the line sensors, in mm on the real robot. */
export interface V5Line {
  readonly left: Vec;
  readonly right: Vec;
  readonly spotRadiusMm: number;
}

/** Mounts the V5's parts. A robot whose V5 registers are never read samples no more ground than one without them. */
export function mountV5(context: RobotContext, motors: Pick<Motors, 'drive'>, places: V5Line): V5 {
  const line = lineOnDemand(context, places);
  const lights = [createCarLight(context.clock), createCarLight(context.clock)] as const;
  const { onSet } = context;
  const walker = createLineWalker();
  let isWalking = false;
  let grade = 1;

  const walk = (isOn: boolean): void => {
    if (isWalking && !isOn) motors.drive(0, 0);
    if (isWalking || isOn) for (const side of BOTH_SIDES) onSet?.(`wheel-${side}`, isOn ? `line ${grade}` : 0);
    isWalking = isOn;
  };
  const sees = (name: LineName): boolean => !line.now().isBright(name);
  const light = (eye: LightEye): number => Math.round(context.lightLevel(eye) * LIGHT_PER_LEVEL);
  return {
    registers: [
      ...lightRegisters(lights, onSet),
      liveRegisters(LINE_BITS, 1, () => bitsOf(BITS, sees)),
      wordRegisters(LINE_VALUES, CHANNELS.length, 'high-first', (channel) => {
        const name = CHANNELS[channel] ?? null;
        return name === null ? 0 : line.now().reading(name);
      }),
      wordRegisters(LIGHT, 2, 'high-first', (word) => light(word === 0 ? LIGHT_EYES.left : LIGHT_EYES.right)),
      ...batteryRegisters(context.supplyMv),
      memoryRegisters(START_ANEW, 1, () => {
        for (const light of lights) light.colour(0);
        for (const side of BOTH_SIDES) onSet?.(`light-${side}`, 0);
        walk(false);
      }),
      memoryRegisters(LINE_WALKING, 2, ([isOn = 0, speed = 0]) => {
        grade = speed;
        walk(isOn === 1);
      }),
    ],
    isLit: (side) => lights[side].isLit(),
    stop: line.stop,
    step: () => {
      line.moved();
      if (!isWalking) return;
      const view = { left: sees('left'), middle: sees('middle'), right: sees('right') };
      const { left, right } = walker.next(view, WALKING_SPEEDS[grade] ?? WALKING_SPEEDS[0]);
      motors.drive(left / FULL_BYTE, right / FULL_BYTE);
    },
  };
}

/** Line sensors that look at the ground at most once per step, and only when they are read. */
function lineOnDemand(context: RobotContext, { left, right, spotRadiusMm }: V5Line) {
  let row: LineRow<LineName> | null = null;
  let isStale = false;
  const now: RobotContext['ground'] = (spot, radiusMm) => context.ground(spot, radiusMm);
  const places = [
    { name: 'left', atMm: left },
    { name: 'middle', atMm: { x: (left.x + right.x) / 2, y: (left.y + right.y) / 2 } },
    { name: 'right', atMm: right },
  ] as const;
  return {
    moved: (): void => {
      isStale = true;
    },
    now: (): LineRow<LineName> => {
      if (row === null)
        row = mountLineRow<LineName>({ ...context, ground: now }, places, { spotRadiusMm, ...BRIGHTNESS });
      else if (isStale) {
        row.sample();
        // All three look at once, whichever is read.
        for (const { name } of places) row.isBright(name);
      }
      isStale = false;
      return row;
    },
    stop: () => row?.stop(),
  };
}

function lightRegisters([left, right]: readonly [CarLight, CarLight], onSet?: OnSet): RegisterPart[] {
  const acts = [
    (byte: number) => left.colour(byte),
    (byte: number) => right.colour(byte),
    (byte: number) => left.flash(byte),
    (byte: number) => left.flashGrade(byte),
    (byte: number) => right.flash(byte),
    (byte: number) => right.flashGrade(byte),
    (byte: number) => left.change(byte),
    (byte: number) => right.change(byte),
  ];
  const bytes = new Uint8Array(acts.length);
  return [
    {
      first: CAR_LIGHTS,
      count: acts.length,
      read: (offset) => bytes[offset] ?? 0,
      write: (offset, byte) => {
        bytes[offset] = byte;
        acts[offset]?.(byte);
        const side = LEFT_LIGHT.includes(offset) ? 'left' : 'right';
        onSet?.(`light-${side}`, bytes.filter((_, at) => LEFT_LIGHT.includes(at) === (side === 'left')).join());
      },
    },
  ];
}

/** The registers of the left one, counted from the first. */
const LEFT_LIGHT: readonly number[] = [0, 2, 3, 6];

function batteryRegisters(supplyMv: () => number): RegisterPart[] {
  let kind = 0;
  return [
    memoryRegisters(BATTERY_KIND, 1, ([byte = 0]) => {
      kind = byte;
    }),
    liveRegisters(BATTERY, 1, () => {
      const { empty, full } = CELLS_MV[kind === 1 ? 1 : 0];
      return Math.round(Math.min(Math.max((supplyMv() - empty) / (full - empty), 0), 1) * 100);
    }),
  ];
}
