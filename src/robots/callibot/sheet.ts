/** Calli:bot: what the gallery tells about it. */
import { wordsOf } from '#core/words';
import type { RegisterTable, RobotSheet, WiringRow } from '../robot';
import bumperDe from './examples/bumper.de.py?raw';
import bumperFr from './examples/bumper.fr.py?raw';
import bumperIt from './examples/bumper.it.py?raw';
import bumperEn from './examples/bumper.en.py?raw';
import encoderDe from './examples/encoder.de.py?raw';
import encoderFr from './examples/encoder.fr.py?raw';
import encoderIt from './examples/encoder.it.py?raw';
import encoderEn from './examples/encoder.en.py?raw';
import firstDriveDe from './examples/first_drive.de.py?raw';
import firstDriveFr from './examples/first_drive.fr.py?raw';
import firstDriveIt from './examples/first_drive.it.py?raw';
import firstDriveEn from './examples/first_drive.en.py?raw';
import lightsDe from './examples/lights.de.py?raw';
import lightsFr from './examples/lights.fr.py?raw';
import lightsIt from './examples/lights.it.py?raw';
import lightsEn from './examples/lights.en.py?raw';
import lineDe from './examples/line.de.py?raw';
import lineFr from './examples/line.fr.py?raw';
import lineIt from './examples/line.it.py?raw';
import lineEn from './examples/line.en.py?raw';
import servoDe from './examples/servo.de.py?raw';
import servoFr from './examples/servo.fr.py?raw';
import servoIt from './examples/servo.it.py?raw';
import servoEn from './examples/servo.en.py?raw';
import type de from './words/sheet/de.json';

const words = wordsOf(import.meta.glob<typeof de>('./words/sheet/*.json', { eager: true, import: 'default' }));

const wiring: readonly WiringRow[] = [
  { ...words.wiring.linkCalliopeMini, at: 'A0: SCL, SDA' },
  { ...words.wiring.motors, at: '0x20, 0x22' },
  { ...words.wiring.redFrontLights, at: '0x21, 0x22' },
  { ...words.wiring.fourColourLights, at: '0x21, 0x22' },
  { ...words.wiring.lineSensorsLeft, at: '0x21, 0x22' },
  { ...words.wiring.bumperLeftRight, at: '0x21, 0x22' },
  { ...words.wiring.ultrasonicSensor, at: '0x21, 0x22' },
  { ...words.wiring.wheelEncodersLeft, at: '0x22' },
  { ...words.wiring.servosS1S2, at: '0x20' },
];

const motorsTable: RegisterTable = {
  address: 0x20,
  title: words.registers.motors.title,
  rows: [
    { register: '0x00', access: 'W', meaning: words.registers.motors.leftDirectionPower },
    { register: '0x02', access: 'W', meaning: words.registers.motors.rightDirectionPower },
    { register: '0x14', access: 'W', meaning: words.registers.motors.servoS1Angle },
    { register: '0x15', access: 'W', meaning: words.registers.motors.servoS2Angle },
  ],
};

const lightsTable: RegisterTable = {
  address: 0x21,
  title: words.registers.lights.title,
  rows: [
    { register: '0x00', access: 'W', meaning: words.registers.lights.redLightsBit },
    { register: '0x01 … 0x04', access: 'W', meaning: words.registers.lights.colourLightsBit },
    { register: 'Byte 0', access: 'R', meaning: words.registers.lights.bitLineRight },
    { register: 'Byte 1, 2', access: 'R', meaning: words.registers.lights.distanceMmHigh },
  ],
};

const registersTable: RegisterTable = {
  address: 0x22,
  title: words.registers.all.title,
  rows: [
    { register: '0x01', access: 'W', meaning: words.registers.all.motorsLightsOff },
    { register: '0x02', access: 'W', meaning: words.registers.all.whichMotorLeft },
    { register: '0x03', access: 'W', meaning: words.registers.all.colourLightRed },
    { register: '0x05', access: 'W', meaning: words.registers.all.encodersLeftRight },
    { register: '0x80', access: 'R', meaning: words.registers.all.asByteAt },
    { register: '0x81 …', access: 'R', meaning: words.registers.all.everyAnswerBegins },
    { register: '0x81', access: 'R', meaning: words.registers.all.distanceMm },
    { register: '0x82', access: 'R', meaning: words.registers.all.typeCalliBot },
    { register: '0x83', access: 'R', meaning: words.registers.all.voltageBatteryMv },
    { register: '0x84', access: 'R', meaning: words.registers.all.voltageLineSensors },
    { register: '0x91', access: 'R', meaning: words.registers.all.encodersLeftRightBytes },
  ],
};

const silentTable: RegisterTable = {
  address: 0x23,
  lastAddress: 0x27,
  title: words.registers.silent.title,
  rows: [{ register: '0x00 … 0xFF', access: 'RW', meaning: words.registers.silent.answerWhenProgram }],
};

export const callibotSheet: RobotSheet = {
  robot: 'callibot',
  about: words.about,
  examples: [
    {
      file: 'first_drive.py',
      title: { de: 'Erste Fahrt', fr: 'Premier trajet', it: 'Primo viaggio', en: 'First drive' },
      source: { de: firstDriveDe, fr: firstDriveFr, it: firstDriveIt, en: firstDriveEn },
      course: 'empty',
    },
    {
      file: 'line.py',
      title: { de: 'Einer Linie folgen', fr: 'Suivre une ligne', it: 'Seguire una linea', en: 'Follow a line' },
      source: { de: lineDe, fr: lineFr, it: lineIt, en: lineEn },
      course: 'closed-line',
    },
    {
      file: 'bumper.py',
      title: {
        de: 'Anstossen und ausweichen',
        fr: 'Toucher et éviter',
        it: 'Urtare ed evitare',
        en: 'Bump and turn away',
      },
      source: { de: bumperDe, fr: bumperFr, it: bumperIt, en: bumperEn },
      course: 'empty',
    },
    {
      file: 'lights.py',
      title: { de: 'Lichter', fr: 'Lumières', it: 'Luci', en: 'Lights' },
      source: { de: lightsDe, fr: lightsFr, it: lightsIt, en: lightsEn },
    },
    {
      file: 'encoder.py',
      title: {
        de: 'Genau einen halben Meter',
        fr: 'Exactement un demi-mètre',
        it: 'Esattamente mezzo metro',
        en: 'Exactly half a metre',
      },
      source: { de: encoderDe, fr: encoderFr, it: encoderIt, en: encoderEn },
      course: 'empty',
    },
    {
      file: 'servo.py',
      title: { de: 'Ein Servo', fr: 'Un servo', it: 'Un servo', en: 'A servo' },
      source: { de: servoDe, fr: servoFr, it: servoIt, en: servoEn },
      course: 'empty',
      options: { S1: 'claw' },
    },
  ],
  sizeNote: words.sizeNote,
  wiring,
  registers: [motorsTable, lightsTable, registersTable, silentTable],
};
