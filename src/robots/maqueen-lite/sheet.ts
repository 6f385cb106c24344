/** Maqueen Lite: what the gallery tells about it. */
import type { RobotSheet } from '../robot';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import ringDe from './examples/ring.de.py?raw';
import ringEn from './examples/ring.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoEn from './examples/servo.en.py?raw';
import squareDe from './examples/square.de.py?raw';
import squareEn from './examples/square.en.py?raw';

export const maqueenLiteSheet: RobotSheet = {
  robot: 'maqueen-lite',
  about: {
    de: 'Der kleine Roboter von DFRobot, den viele Schulen haben. Er hat zwei Motoren, zwei Liniensensoren, Ultraschall, rote und farbige Lichter und zwei Anschlüsse für Servos.',
    en: 'The small robot by DFRobot that many schools have. It has two motors, two line sensors, an ultrasonic sensor, red and coloured lights and two servo ports.',
  },
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', en: 'First drive' },
      source: { de: firstDriveDe, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'square.py',
      title: { de: 'Ein Quadrat fahren', en: 'Drive a square' },
      source: { de: squareDe, en: squareEn },
      course: 'empty',
    },
    { file: 'lights.py', title: { de: 'Lichter', en: 'Lights' }, source: { de: lightsDe, en: lightsEn } },
    {
      file: 'ring.py',
      title: { de: 'Lichterring', en: 'Ring of lights' },
      source: { de: ringDe, en: ringEn },
      course: 'empty',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', en: 'A servo' },
      source: { de: servoDe, en: servoEn },
      course: 'empty',
      options: { S1: 'claw' },
    },
  ],
  wiring: [
    {
      part: { de: 'Motoren und Servos', en: 'Motors and servos' },
      at: 'I2C 0x10',
      note: { de: 'SCL an P19, SDA an P20', en: 'SCL at P19, SDA at P20' },
    },
    {
      part: { de: 'Rotes Licht links', en: 'Left red light' },
      at: 'P8',
      note: { de: '1 ein, 0 aus', en: '1 on, 0 off' },
    },
    {
      part: { de: 'Rotes Licht rechts', en: 'Right red light' },
      at: 'P12',
      note: { de: '1 ein, 0 aus', en: '1 on, 0 off' },
    },
    {
      part: { de: 'Liniensensor links', en: 'Left line sensor' },
      at: 'P13',
      note: { de: '1 auf hellem, 0 auf dunklem Boden', en: '1 on light, 0 on dark ground' },
    },
    {
      part: { de: 'Liniensensor rechts', en: 'Right line sensor' },
      at: 'P14',
      note: { de: '1 auf hellem, 0 auf dunklem Boden', en: '1 on light, 0 on dark ground' },
    },
    { part: { de: 'Ultraschall: Auslöser', en: 'Ultrasonic: trigger' }, at: 'P1' },
    {
      part: { de: 'Ultraschall: Echo', en: 'Ultrasonic: echo' },
      at: 'P2',
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
    { part: { de: 'Summer', en: 'Buzzer' }, at: 'P0' },
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
        { register: '0x14', access: 'RW', meaning: { de: 'Servo S1: 0–180 Grad', en: 'servo S1: 0–180 degrees' } },
        { register: '0x15', access: 'RW', meaning: { de: 'Servo S2: 0–180 Grad', en: 'servo S2: 0–180 degrees' } },
        {
          register: '0x32',
          access: 'R',
          meaning: { de: 'Länge des Versionstextes', en: 'length of the version text' },
        },
        { register: '0x33 …', access: 'R', meaning: { de: 'Versionstext', en: 'version text' } },
      ],
    },
  ],
};
