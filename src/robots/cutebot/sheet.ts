/** Cutebot: its page in the gallery. */
import type { RegisterTable, RobotSheet } from '../robot';
import words from './words/sheet';
import claw from './examples/claw.py?languages';
import distance from './examples/distance.py?languages';
import firstDrive from './examples/first_drive.py?languages';
import lights from './examples/lights.py?languages';
import line from './examples/line.py?languages';

const controller: RegisterTable = {
  address: 0x10,
  title: words.frames.title,
  rows: [
    { register: '1', access: 'W', meaning: words.frames.motorLeft },
    { register: '2', access: 'W', meaning: words.frames.motorRight },
    { register: '4', access: 'W', meaning: words.frames.lampLeft },
    { register: '8', access: 'W', meaning: words.frames.lampRight },
    { register: '5', access: 'W', meaning: words.frames.servo1 },
    { register: '6', access: 'W', meaning: words.frames.servo2 },
  ],
};

export const cutebotSheet: RobotSheet = {
  robot: 'cutebot',
  about: words.about,
  sizeNote: words.sizeNote,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...line, course: 'closed-line' },
    { ...distance, course: 'empty' },
    { ...lights, course: 'empty' },
    { ...claw, course: 'empty', options: { S1: 'claw' } },
  ],
  wiring: [
    { ...words.wiring.motorsLampsServos, at: 'I2C 0x10' },
    { part: words.wiring.ultrasonicTrigger, at: 'P8' },
    { ...words.wiring.ultrasonicEcho, at: 'P12' },
    { ...words.wiring.lineLeft, at: 'P13' },
    { ...words.wiring.lineRight, at: 'P14' },
    { ...words.wiring.lightsBelow, at: 'P15' },
    { part: words.wiring.buzzer, at: 'P0' },
    { ...words.wiring.infraredReceiver, at: 'P16' },
    { part: words.wiring.free, at: 'P1, P2' },
  ],
  registers: [controller],
};
