/** Maqueen Plus V2: what the gallery tells about it. */
import type { RobotSheet } from '../robot';
import distanceDe from './examples/distance.de.py?raw';
import distanceEn from './examples/distance.en.py?raw';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineEn from './examples/line.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoEn from './examples/servo.en.py?raw';

export const maqueenPlusV2Sheet: RobotSheet = {
  robot: 'maqueen-plus-v2',
  about: {
    de: 'Der grössere Roboter von DFRobot, mit Metallrahmen und Akku. Fünf Liniensensoren messen auch, wie hell der Boden ist. Dazu kommen Ultraschall, rote und farbige Lichter und drei Anschlüsse für Servos.',
    en: 'The larger robot by DFRobot, with a metal frame and a rechargeable battery. Its five line sensors also measure how light the ground is. It has an ultrasonic sensor, red and coloured lights and three servo ports.',
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
      file: 'distance.py',
      title: { de: 'Nicht anstossen', en: 'Do not bump' },
      source: { de: distanceDe, en: distanceEn },
      course: 'empty',
    },
    {
      file: 'lights.py',
      title: { de: 'Lichter und Helligkeit', en: 'Lights and brightness' },
      source: { de: lightsDe, en: lightsEn },
      course: 'closed-line',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', en: 'A servo' },
      source: { de: servoDe, en: servoEn },
      course: 'empty',
      options: { P1: 'claw' },
    },
  ],
  wiring: [
    {
      part: { de: 'Motoren, rote Lichter, Liniensensoren', en: 'Motors, red lights, line sensors' },
      at: 'I2C 0x10',
      note: { de: 'SCL an P19, SDA an P20', en: 'SCL at P19, SDA at P20' },
    },
    { part: { de: 'Ultraschall: Auslöser', en: 'Ultrasonic: trigger' }, at: 'P13' },
    {
      part: { de: 'Ultraschall: Echo', en: 'Ultrasonic: echo' },
      at: 'P14',
      note: { de: 'Puls von 58 µs für jeden cm', en: 'pulse of 58 µs for each cm' },
    },
    {
      part: { de: 'Vier Farblichter', en: 'Four colour lights' },
      at: 'P15',
      note: {
        de: 'NeoPixel: 0 vorn links, 1 hinten links, 2 hinten rechts, 3 vorn rechts',
        en: 'NeoPixel: 0 front left, 1 back left, 2 back right, 3 front right',
      },
    },
    {
      part: { de: 'Servos P0, P1, P2', en: 'Servos P0, P1, P2' },
      at: 'P0, P1, P2',
      note: {
        de: 'Puls von 0.5 bis 2.5 ms alle 20 ms: 0 bis 180°',
        en: 'pulse of 0.5 to 2.5 ms every 20 ms: 0 to 180°',
      },
    },
    {
      part: { de: 'Summer', en: 'Buzzer' },
      at: 'P0',
      note: { de: 'derselbe Pin wie der erste Servo', en: 'the same pin as the first servo' },
    },
    {
      part: { de: 'Infrarotempfänger', en: 'Infrared receiver' },
      at: 'P16',
      note: { de: 'hört hier keine Fernbedienung', en: 'hears no remote control here' },
    },
  ],
  registers: [
    {
      address: 0x10,
      title: { de: 'Steuerung des Roboters', en: 'The robot’s controller' },
      rows: [
        {
          register: '0x00',
          access: 'RW',
          meaning: { de: 'linker Motor: 0 vorwärts, 1 rückwärts', en: 'left motor: 0 forward, 1 backward' },
        },
        { register: '0x01', access: 'RW', meaning: { de: 'linker Motor: Kraft 0–255', en: 'left motor: power 0–255' } },
        {
          register: '0x02',
          access: 'RW',
          meaning: { de: 'rechter Motor: 0 vorwärts, 1 rückwärts', en: 'right motor: 0 forward, 1 backward' },
        },
        {
          register: '0x03',
          access: 'RW',
          meaning: { de: 'rechter Motor: Kraft 0–255', en: 'right motor: power 0–255' },
        },
        {
          register: '0x0B',
          access: 'RW',
          meaning: { de: 'linkes rotes Licht: 0 aus, 1 ein', en: 'left red light: 0 off, 1 on' },
        },
        {
          register: '0x0C',
          access: 'RW',
          meaning: { de: 'rechtes rotes Licht: 0 aus, 1 ein', en: 'right red light: 0 off, 1 on' },
        },
        {
          register: '0x1D',
          access: 'R',
          meaning: {
            de: 'Liniensensoren: Bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2; 1 auf dunklem Boden',
            en: 'line sensors: bit 0 R2, 1 R1, 2 M, 3 L1, 4 L2; 1 on dark ground',
          },
        },
        {
          register: '0x1E … 0x27',
          access: 'R',
          meaning: {
            de: 'Helligkeit von R2, R1, M, L1, L2, je zwei Bytes, tiefes Byte zuerst',
            en: 'brightness of R2, R1, M, L1, L2, two bytes each, low byte first',
          },
        },
        {
          register: '0x32',
          access: 'R',
          meaning: { de: 'Länge des Versionstextes', en: 'length of the version text' },
        },
        {
          register: '0x33 …',
          access: 'R',
          meaning: { de: 'Versionstext, zum Beispiel MBT0021-EN-2.1', en: 'version text, such as MBT0021-EN-2.1' },
        },
      ],
    },
  ],
};
