import type { BoardSnapshot, DeviceSnapshot } from '#simulation/snapshot';
import { eyeLevelCells } from '#robots/lidar-fan';
import type { ColourState, LidarState, RobotType } from '#robots/robot';
import type { Key, Leaf } from '#tape/rows/leaves';

import { t } from '../../../kit/i18n';
import words from './words';
import type { Series } from './series';

/** A curve of something that a snapshot shows. */
export interface Reading extends Series {
  /** Its paths in a device's snapshot. */
  readonly paths: readonly (readonly Key[])[];
  /** Its value, from the leaves at its paths; `null`: it has none. */
  value(leaves: readonly (Leaf | undefined)[]): number | null;
  /** True if the curve shows how fast the value grows, per second. */
  readonly isRate: boolean;
}

/** On or off. */
const SWITCH = '0/1';
const DEGREES_PER_RAD = 180 / Math.PI;

type More = Partial<Pick<Reading, 'unit' | 'isRate'>> & { readonly times?: number };

const numberOf = (leaf: Leaf | undefined): number | null => {
  if (typeof leaf === 'boolean') return leaf ? 1 : 0;
  return typeof leaf === 'number' ? leaf : null;
};

/** A reading at one path, which is its id, too; before that of a rate is `rate`. */
function of(name: string, path: readonly Key[], { unit = '', times = 1, isRate = false }: More = {}): Reading {
  const value = ([leaf]: readonly (Leaf | undefined)[]): number | null => {
    const number = numberOf(leaf);
    return number === null ? null : number * times;
  };
  const id = isRate ? `rate ${path.join('/')}` : path.join('/');
  return { id, name, unit, isStepped: unit === SWITCH, paths: [path], value, isRate };
}

const onOff = (name: string, path: readonly Key[]): Reading => of(name, path, { unit: SWITCH });

/**
 * The readings in a device's snapshot that can be drawn.
 *
 * @param type of its robot, if it has one
 */
export function readingsOf(device: DeviceSnapshot, type: RobotType | undefined): readonly Reading[] {
  return [...(type ? robotReadings(device, type) : []), ...boardReadings(device)];
}

/** The name of a line sensor: its side in words, else its name on the robot, `L1`. */
function sideName(name: string): string {
  if (name === 'left' || name === 'right') return t(`arena.${name}`);
  return name === 'middle' ? t(words.middle) : name;
}

function robotReadings({ robot }: DeviceSnapshot, type: RobotType): readonly Reading[] {
  if (robot === null) return [];
  const { state, scale } = robot;
  const wheel = (side: 0 | 1): Reading =>
    of(t(side === 0 ? words.wheelLeft : words.wheelRight), ['robot', 'wheelTurnRad', side], {
      unit: 'cm/s',
      times: (type.body.wheels[side].radiusMm * scale) / 10,
      isRate: true,
    });
  const at = (name: keyof typeof state, ...more: Key[]): readonly Key[] => ['robot', 'state', name, ...more];
  return [
    ...(state.ultrasonic === null
      ? []
      : [of(t('arena.distance'), at('ultrasonic', 'distanceMm'), { unit: 'cm', times: 0.1 })]),
    ...(state.lidar === null
      ? []
      : [
          lidarLeast(t('arena.lidar'), LIDAR_ID, at('lidar'), (size) => eyeLevelCells(size)),
          lidarLeast(t(words.lidarMiddle), `${LIDAR_ID}/middle`, at('lidar'), middleCells),
        ]),
    ...(state.colours ?? []).flatMap(({ side }, place) => colourReadings(side, at('colours', place))),
    ...(state.camera === undefined ? [] : cameraReadings(at('camera', 'seen', 0))),
    ...state.lineSensors.flatMap(({ name, reading }, place) => [
      onOff(t(words.line, { name: sideName(name) }), at('lineSensors', place, 'bright')),
      ...(reading === undefined
        ? []
        : [of(t(words.lineAnalog, { name: sideName(name) }), at('lineSensors', place, 'reading'))]),
    ]),
    of(t(words.speed), ['robot', 'pathMm'], { unit: 'cm/s', times: 0.1, isRate: true }),
    wheel(0),
    wheel(1),
    of(t(words.motorLeft), at('duty', 'left'), { unit: '%', times: 100 }),
    of(t(words.motorRight), at('duty', 'right'), { unit: '%', times: 100 }),
    of(t(words.heading), ['robot', 'pose', 'headingRad'], { unit: '°', times: DEGREES_PER_RAD }),
    of(t(words.turned), ['robot', 'turnedRad'], { unit: '°', times: DEGREES_PER_RAD }),
    of('x', ['robot', 'pose', 'xMm'], { unit: 'cm', times: 0.1 }),
    of('y', ['robot', 'pose', 'yMm'], { unit: 'cm', times: 0.1 }),
    of(t(words.way), ['robot', 'pathMm'], { unit: 'cm', times: 0.1 }),
    of(t(words.touches), ['robot', 'collisions']),
    ...(state.lamps.length === 0
      ? [onOff(t(words.lightLeft), at('leds', 'left')), onOff(t(words.lightRight), at('leds', 'right'))]
      : [colourLight(t(words.lightLeft), at('lamps', 0)), colourLight(t(words.lightRight), at('lamps', 1))]),
    ...state.rgb.map((_, place) => colourLight(t(words.colourLight, { number: place + 1 }), at('rgb', place))),
    ...Object.keys(state.servos).map((port) => of(`Servo ${port}`, at('servos', port), { unit: '°' })),
    ...(state.bumper === null
      ? []
      : [onOff(t(words.bumperLeft), at('bumper', 'left')), onOff(t(words.bumperRight), at('bumper', 'right'))]),
  ];
}

const LIDAR_ID = 'robot/state/lidar/depthMm';

/** The four cells around the middle, whose least depth `getDistance` of the V3's library gives. */
const middleCells = (size: LidarState['size']): readonly number[] => {
  const [from, to] = [size / 2 - 1, size / 2];
  return [from * size + from, from * size + to, to * size + from, to * size + to];
};

/** The least depth in some cells of a lidar, which may look with 8 × 8 cells now and with 4 × 4 at another moment. */
function lidarLeast(
  name: string,
  id: string,
  path: readonly Key[],
  cellsOf: (size: LidarState['size']) => readonly number[],
): Reading {
  const [few, many] = [cellsOf(4), cellsOf(8)];
  return {
    ...{ id, name, unit: 'cm', isStepped: false, isRate: false },
    paths: [[...path, 'size'], ...[...few, ...many].map((cell) => [...path, 'depthMm', cell])],
    value([size, ...depths]) {
      const own = size === 4 ? depths.slice(0, few.length) : depths.slice(few.length);
      const seen = own.map(numberOf).filter((depth) => depth !== null);
      return seen.length === 0 ? null : Math.min(...seen) / 10;
    },
  };
}

/** The figures of a colour sensor: hue, and what a program reads at gain 4 and 24 ms. */
function colourReadings(side: ColourState['side'], path: readonly Key[]): readonly Reading[] {
  const name = (value: string): string => t(side === 'down' ? words.colour : words.colourAhead, { value });
  const raw = ['C', 'R', 'G', 'B'].map((letter, i) => of(name(letter), [...path, 'raw', i]));
  return [of(name(t(words.hue)), [...path, 'hue'], { unit: '°' }), ...raw];
}

/** The first thing in the last answer of a camera; of a line the far end. */
function cameraReadings(first: readonly Key[]): readonly Reading[] {
  const width = of(t(words.cameraWidth), [...first, 'width'], { unit: 'px' });
  const id = { ...of(t(words.cameraId), [...first, 'id']), isStepped: true };
  const x: Reading = {
    ...of(t(words.cameraX), [...first, 'x'], { unit: 'px' }),
    paths: [
      [...first, 'x'],
      [...first, 'head', 0],
    ],
    value: ([block, arrow]) => numberOf(block) ?? numberOf(arrow),
  };
  return [x, width, id];
}

/** A colour light, by the brightest of its three colours in per cent. */
function colourLight(name: string, path: readonly Key[]): Reading {
  return {
    ...{ id: path.join('/'), name, unit: '%', isStepped: true, isRate: false },
    paths: [0, 1, 2].map((colour) => [...path, colour]),
    value(leaves) {
      const colours = leaves.map(numberOf).filter((colour) => colour !== null);
      return colours.length === 0 ? null : Math.max(...colours) / 2.55;
    },
  };
}

const sensorNames: Readonly<Record<string, () => string>> = {
  accelerometerX: () => t('sensors.accelerometer', { axis: 'x' }),
  accelerometerY: () => t('sensors.accelerometer', { axis: 'y' }),
  accelerometerZ: () => t('sensors.accelerometer', { axis: 'z' }),
  compassX: () => t('sensors.compass', { axis: 'x' }),
  compassY: () => t('sensors.compass', { axis: 'y' }),
  compassZ: () => t('sensors.compass', { axis: 'z' }),
  compassHeading: () => t('sensors.compassHeading'),
  temperature: () => t('sensors.temperature'),
  lightLevel: () => t('sensors.lightLevel'),
  soundLevel: () => t('sensors.soundLevel'),
};
const sensorUnits: Readonly<Record<string, string>> = {
  ...{ accelerometerX: 'mg', accelerometerY: 'mg', accelerometerZ: 'mg' },
  ...{ compassX: 'nT', compassY: 'nT', compassZ: 'nT', compassHeading: '°', temperature: '°C' },
};

function boardReadings(board: BoardSnapshot): readonly Reading[] {
  return [
    ...Object.entries(sensorNames).flatMap(([id, name]) =>
      id in board.sensors ? [of(name(), ['sensors', id], { unit: sensorUnits[id] ?? '' })] : [],
    ),
    onOff(t(words.button, { name: 'A' }), ['buttons', 'a']),
    onOff(t(words.button, { name: 'B' }), ['buttons', 'b']),
    ...Object.keys(board.touch).map((pad) => onOff(t(words.touch, { name: pad }), ['touch', pad])),
    ...board.motors.map((_, place) =>
      of(t(words.motor, { number: place + 1 }), ['motors', place], { unit: '%', times: 100 }),
    ),
    ...board.rgb.map((_, place) => colourLight(t(words.boardLight, { number: place + 1 }), ['rgb', place])),
    of(t(words.tone), ['sound', 'hz'], { unit: 'Hz' }),
  ];
}

/** The curves drawn by default: ids in their order, as far as they exist. */
const USUAL: readonly (readonly string[])[] = [
  ['robot/state/ultrasonic/distanceMm', LIDAR_ID, 'rate robot/pathMm'],
  ['sensors/accelerometerX', 'sensors/accelerometerY'],
];

/** The ids of the curves that are drawn before anybody has chosen. */
export function usualReadings(readings: readonly Reading[]): readonly string[] {
  const known = new Set(readings.map(({ id }) => id));
  return USUAL.map((ids) => ids.filter((id) => known.has(id))).find((ids) => ids.length > 0) ?? [];
}
