/** Calli:bot: its page in the gallery. */
import type { RegisterTable, RobotSheet, WiringRow } from '../robot';
import words from './words/sheet';
import bumper from './examples/bumper.py?languages';
import encoder from './examples/encoder.py?languages';
import firstDrive from './examples/first_drive.py?languages';
import lights from './examples/lights.py?languages';
import line from './examples/line.py?languages';
import servo from './examples/servo.py?languages';

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
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...bumper, course: 'empty' },
    lights,
    { ...encoder, course: 'empty' },
    { ...servo, course: 'empty', options: { S1: 'claw' } },
  ],
  sizeNote: words.sizeNote,
  wiring,
  registers: [motorsTable, lightsTable, registersTable, silentTable],
};
