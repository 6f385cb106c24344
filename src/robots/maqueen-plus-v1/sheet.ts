/** Maqueen Plus V1: its page in the gallery. */
import type { RegisterTable, RobotSheet } from '../robot';
import words from './words/sheet';
import firstDrive from './examples/first_drive.py?languages';
import line from './examples/line.py?languages';
import wheels from './examples/wheels.py?languages';

const controller: RegisterTable = {
  address: 0x10,
  title: words.controller.title,
  rows: [
    { register: '0x00, 0x02', access: 'RW', meaning: words.controller.directionLeftRight },
    { register: '0x01, 0x03', access: 'RW', meaning: words.controller.powerLeftRight },
    { register: '0x04 … 0x07', access: 'RW', meaning: words.controller.pulsesWheelsLeft },
    { register: '0x0A', access: 'RW', meaning: words.controller.robotKeepsSpeed },
    { register: '0x0B, 0x0C', access: 'RW', meaning: words.controller.lightLeftRight },
    { register: '0x14 … 0x16', access: 'RW', meaning: words.controller.angleServosS1 },
    { register: '0x1D', access: 'R', meaning: words.controller.lineSensorsBit },
    { register: '0x1E … 0x29', access: 'R', meaning: words.controller.brightnessBelowL3 },
    { register: '0x32, 0x33 …', access: 'R', meaning: words.controller.lengthVersionText },
  ],
};

export const maqueenPlusV1Sheet: RobotSheet = {
  robot: 'maqueen-plus-v1',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...wheels, course: 'empty' },
  ],
  wiring: [
    { ...words.wiring.motorsLightsServos, at: 'I2C 0x10' },
    { part: words.wiring.ultrasonicTrigger, at: 'P1' },
    { ...words.wiring.ultrasonicEcho, at: 'P2' },
    { part: words.wiring.buzzer, at: 'P0' },
  ],
  registers: [controller],
};
