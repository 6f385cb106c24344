/**
 * DFRobot Maqueen Plus V2: its body. Frame and units: see ../robot.ts. Where each number comes from: SOURCES.md;
 * NOE = NoeSchaller/TS_Maqueen (its Maqueen Plus is the V1, of the same shape), GBSL = GBSL-Informatik/maqueen-plus-v2-mpy.
 */
import { attachmentOptions } from '#attachments/options';
import type { Option } from '#core/option';
import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';
import type { RobotType } from '../robot';
import drawing from './robot.svg?raw';

/** Ports of the three servos, named after the pins they hang on. */
export const SERVO_PORTS = ['P0', 'P1', 'P2'] as const;

/** Distance between the middles of the wheels: Tiger-Jython/Aplu-Libraries and jhautbois/maqueen-plus-v3 (82). */
const TRACK_MM = 82;
const WHEEL_RADIUS_MM = 21.5; // diameter 43: MINTspark/pxt-mintspark-drivemaqueenplusv2
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

const body: ChassisType = {
  outlineMm: [FRONT, REAR_WITH_WHEELS],
  massG: 230, // chosen, not weighed: metal frame and motors, 9 g micro:bit, 46 g cell
  centreOfMassMm: { x: 12, y: 0 }, // between axle and castor, near the axle, as the cell lies behind it: chosen
  wheels: [
    { atMm: { x: 0, y: TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
    { atMm: { x: 0, y: -TRACK_MM / 2 }, radiusMm: WHEEL_RADIUS_MM, gripMu: GRIP_MU },
  ],
  castorMm: { x: 46, y: 0 }, // chosen: behind the middle line sensor
  drive: {
    // Fitted: scripts/fit-motor-law.mjs, residuals in docs/hardware/maqueen-plus-v2-motor-law.md
    v0MmPerS: 247,
    coulomb: 0,
    breakaway: { share: 0.0364, until: 0.3277 },
    viscous: 0.1547,
    yawResistance: 0.1294,
    stallForceN: 1.5, // chosen: the same kind of gear motor as the Lite's, on 3.7 V through a regulator
    // chosen: 0.1 s at the usual speed of 50; with the Lite's 0.03 the first circles begin as spirals, as a wheel at byte 15
    // then takes a second to reach its speed
    lagS: 0.02,
  },
};

const options: readonly Option[] = [
  ...attachmentOptions(SERVO_PORTS),
  {
    id: 'version',
    title: { de: 'Version des Roboters', fr: 'Version du robot', it: 'Versione del robot', en: 'Version of the robot' },
    about: {
      de: 'Was der Roboter antwortet, wenn ein Programm nach seiner Version fragt.',
      fr: 'Ce que le robot répond quand un programme demande sa version.',
      it: 'Quello che il robot risponde quando un programma chiede la sua versione.',
      en: 'What the robot answers when a program asks for its version.',
    },
    choices: [
      { id: '2.1', title: { de: '2.1', fr: '2.1', it: '2.1', en: '2.1' } },
      { id: '2.0', title: { de: '2.0', fr: '2.0', it: '2.0', en: '2.0' } },
    ],
  },
  {
    id: 'analogOrder',
    title: {
      de: 'Reihenfolge der Helligkeitswerte',
      fr: 'Ordre des valeurs de luminosité',
      it: 'Ordine dei valori di luminosità',
      en: 'Order of the brightness values',
    },
    about: {
      de: 'Roboter der gleichen Version melden die Werte der Liniensensoren mal von rechts, mal von links her.',
      fr: 'Des robots de la même version indiquent les valeurs des capteurs de ligne tantôt depuis la droite, tantôt depuis la gauche.',
      it: 'Robot della stessa versione danno i valori dei sensori di linea a volte da destra, a volte da sinistra.',
      en: 'Robots of the same version report the values of the line sensors from the right or from the left.',
    },
    choices: [
      {
        id: 'R2-first',
        title: { de: 'rechts zuerst', fr: 'droite d’abord', it: 'prima la destra', en: 'right first' },
      },
      {
        id: 'L2-first',
        title: { de: 'links zuerst', fr: 'gauche d’abord', it: 'prima la sinistra', en: 'left first' },
      },
    ],
  },
  {
    id: 'analogPolarity',
    title: {
      de: 'Grosser Helligkeitswert heisst',
      fr: 'Une grande valeur signifie',
      it: 'Un valore alto significa',
      en: 'A high brightness value means',
    },
    about: {
      de: 'Roboter der gleichen Version melden auf hellem Boden mal einen grossen, mal einen kleinen Wert.',
      fr: 'Sur un sol clair, des robots de la même version indiquent tantôt une grande valeur, tantôt une petite.',
      it: 'Su pavimento chiaro, robot della stessa versione danno a volte un valore alto, a volte uno basso.',
      en: 'On light ground some robots of the same version report a high value, some a low one.',
    },
    choices: [
      { id: 'light-high', title: { de: 'heller Boden', fr: 'sol clair', it: 'pavimento chiaro', en: 'light ground' } },
      { id: 'light-low', title: { de: 'dunkler Boden', fr: 'sol sombre', it: 'pavimento scuro', en: 'dark ground' } },
    ],
  },
  {
    id: 'echo',
    title: {
      de: 'Ultraschall ohne Hindernis',
      fr: 'Ultrasons sans obstacle',
      it: 'Ultrasuoni senza ostacolo',
      en: 'Ultrasonic without an obstacle',
    },
    choices: [
      { id: 'none', title: { de: 'kein Echo', fr: 'pas d’écho', it: 'nessuna eco', en: 'no echo' } },
      {
        id: 'long-pulse',
        title: { de: 'Echo von 38 ms', fr: 'écho de 38 ms', it: 'eco di 38 ms', en: 'echo of 38 ms' },
      },
    ],
  },
];

export const maqueenPlusV2: RobotType = {
  id: 'maqueen-plus-v2',
  name: 'Maqueen Plus V2',
  place: 2,
  board: 'microbit-v2',
  body,
  modules: ['mbrobot_plusV2'],
  driverNames: ['maqueenplusv2', 'maqueen_plus'], // the latter: almasy
  options,
  mountMm: { x: 78.5, y: 0 },
  drawing,
};
