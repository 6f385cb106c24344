/** Maqueen Plus V1: what the gallery tells about it. */
import type { RegisterTable, RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineEn from './examples/line.en.py?raw';
import wheelsDe from './examples/wheels.de.py?raw';
import wheelsEn from './examples/wheels.en.py?raw';

const controller: RegisterTable = {
  address: 0x10,
  title: { de: 'Steuerung des Roboters', en: 'The robot’s controller' },
  rows: [
    {
      register: '0x00, 0x02',
      access: 'RW',
      meaning: {
        de: 'Richtung links, rechts: 0 halt, 1 vorwärts, 2 rückwärts',
        en: 'direction left, right: 0 stop, 1 forward, 2 backward',
      },
    },
    {
      register: '0x01, 0x03',
      access: 'RW',
      meaning: { de: 'Kraft links, rechts: 0 bis 255', en: 'power left, right: 0 to 255' },
    },
    {
      register: '0x04 … 0x07',
      access: 'RW',
      meaning: {
        de: 'Pulse der Räder, links, dann rechts, hohes Byte zuerst; 80 sind eine Umdrehung. Schreiben stellt sie auf 0.',
        en: 'pulses of the wheels, left, then right, high byte first; 80 are one turn. A write sets them to 0.',
      },
    },
    {
      register: '0x0A',
      access: 'RW',
      meaning: { de: '1 = der Roboter hält sein Tempo selbst', en: '1 = the robot keeps its speed by itself' },
    },
    {
      register: '0x0B, 0x0C',
      access: 'RW',
      meaning: {
        de: 'Licht links, rechts: 1 rot, 2 grün, 3 gelb, 4 blau, 5 rosa, 6 türkis, 7 weiss, 8 aus',
        en: 'light left, right: 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white, 8 off',
      },
    },
    {
      register: '0x14 … 0x16',
      access: 'RW',
      meaning: { de: 'Winkel der Servos S1, S2, S3 in Grad', en: 'angle of the servos S1, S2, S3 in degrees' },
    },
    {
      register: '0x1D',
      access: 'R',
      meaning: {
        de: 'Liniensensoren: Bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3; 1 auf dunklem Boden',
        en: 'line sensors: bit 0 L3, 1 L2, 2 L1, 3 R1, 4 R2, 5 R3; 1 on dark ground',
      },
    },
    {
      register: '0x1E … 0x29',
      access: 'R',
      meaning: {
        de: 'Helligkeit unter L3, L2, L1, R1, R2, R3, je zwei Bytes, hohes Byte zuerst; bis 4095',
        en: 'brightness below L3, L2, L1, R1, R2, R3, two bytes each, high byte first; up to 4095',
      },
    },
    {
      register: '0x32, 0x33 …',
      access: 'R',
      meaning: { de: 'Länge des Versionstextes, dann der Text', en: 'length of the version text, then the text' },
    },
  ],
};

export const maqueenPlusV1Sheet: RobotSheet = {
  robot: 'maqueen-plus-v1',
  about: {
    de: 'Der erste Maqueen Plus von DFRobot. Er hat sechs Liniensensoren, farbige Lichter vorn, Ultraschall und drei Anschlüsse für Servos. Seine Räder zählen mit, wie weit sie sich drehen, und er kann sein Tempo selbst halten.',
    en: 'The first Maqueen Plus by DFRobot. It has six line sensors, coloured lights in front, an ultrasonic sensor and three servo ports. Its wheels count how far they turn, and it can keep its speed by itself.',
  },
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', en: 'First drive' },
      source: { de: firstDriveDe, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'line.py',
      title: { de: 'Einer Linie folgen', en: 'Follow a line' },
      source: { de: lineDe, en: lineEn },
      course: 'closed-line',
    },
    {
      file: 'wheels.py',
      title: { de: 'Genau einen halben Meter', en: 'Exactly half a metre' },
      source: { de: wheelsDe, en: wheelsEn },
      course: 'empty',
    },
  ],
  wiring: [
    {
      part: {
        de: 'Motoren, Lichter, Servos, Liniensensoren, Radzähler',
        en: 'Motors, lights, servos, line sensors, wheel encoders',
      },
      at: 'I2C 0x10',
      note: { de: 'SCL an P19, SDA an P20', en: 'SCL at P19, SDA at P20' },
    },
    { part: { de: 'Ultraschall: Auslöser', en: 'Ultrasonic: trigger' }, at: 'P1' },
    {
      part: { de: 'Ultraschall: Echo', en: 'Ultrasonic: echo' },
      at: 'P2',
      note: { de: 'Puls von 58 µs für jeden cm', en: 'pulse of 58 µs for each cm' },
    },
    { part: { de: 'Summer', en: 'Buzzer' }, at: 'P0' },
  ],
  registers: [controller],
};
