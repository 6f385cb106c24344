/** Maqueen Plus V3: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import firstDrive from './examples/first_drive.py?languages';
import lidar from './examples/lidar.py?languages';
import measured from './examples/measured.py?languages';
import patrol from './examples/patrol.py?languages';

export const maqueenPlusV3Sheet: RobotSheet = {
  robot: 'maqueen-plus-v3',
  about: words.about,
  examples: [
    { ...firstDrive, course: 'empty' },
    { ...lidar, course: 'empty' },
    { ...patrol, course: 'closed-line' },
    { ...measured, course: 'empty' },
  ],
  wiring: [
    { ...words.wiring.motors, at: 'I2C 0x10' },
    { ...words.wiring.lidar, at: 'I2C 0x33' },
    { ...words.wiring.pixels, at: 'P1' },
    { ...words.wiring.servos, at: 'P0, P1, P2' },
    { ...words.wiring.buzzer, at: 'P0' },
    { ...words.wiring.ultrasonic, at: 'P13, P14' },
    { ...words.wiring.infrared, at: 'P16' },
  ],
  registers: [
    {
      address: 0x10,
      title: words.registers.controller.title,
      rows: [
        { register: '0', access: 'RW', meaning: words.registers.controller.leftForward },
        { register: '1', access: 'RW', meaning: words.registers.controller.leftPower },
        { register: '2', access: 'RW', meaning: words.registers.controller.rightForward },
        { register: '3', access: 'RW', meaning: words.registers.controller.rightPower },
        { register: '11', access: 'RW', meaning: words.registers.controller.leftLamp },
        { register: '12', access: 'RW', meaning: words.registers.controller.rightLamp },
        { register: '29', access: 'R', meaning: words.registers.controller.line },
        { register: '30 … 39', access: 'R', meaning: words.registers.controller.brightness },
        { register: '50', access: 'R', meaning: words.registers.controller.versionLength },
        { register: '51 …', access: 'R', meaning: words.registers.controller.version },
        { register: '60', access: 'RW', meaning: words.registers.controller.mode },
        { register: '61', access: 'R', meaning: words.registers.controller.junction },
        { register: '63', access: 'RW', meaning: words.registers.controller.patrolSpeed },
        { register: '64', access: 'RW', meaning: words.registers.controller.distanceDirection },
        { register: '65, 66', access: 'RW', meaning: words.registers.controller.distance },
        { register: '67', access: 'RW', meaning: words.registers.controller.angleDirection },
        { register: '68', access: 'RW', meaning: words.registers.controller.angle },
        { register: '69 … 72', access: 'RW', meaning: words.registers.controller.ways },
        { register: '73', access: 'W', meaning: words.registers.controller.reset },
        { register: '76, 77', access: 'R', meaning: words.registers.controller.speeds },
        { register: '78 … 81', access: 'R', meaning: words.registers.controller.light },
        { register: '85, 86', access: 'RW', meaning: words.registers.controller.grades },
        { register: '87', access: 'R', meaning: words.registers.controller.busy },
        { register: '90, 91', access: 'RW', meaning: words.registers.controller.driven },
      ],
    },
    {
      address: 0x33,
      title: words.registers.lidar.title,
      rows: [
        { register: '55 00 05 01 00 00 00 08', access: 'W', meaning: words.registers.lidar.mode },
        { register: '55 00 03 03 x y', access: 'W', meaning: words.registers.lidar.point },
        { register: '55 00 01 02', access: 'W', meaning: words.registers.lidar.all },
        { register: '55 00 02 05 x', access: 'W', meaning: words.registers.lidar.column },
        { register: '55 00 01 06', access: 'W', meaning: words.registers.lidar.obstacle },
        { register: '53 …', access: 'R', meaning: words.registers.lidar.reply },
      ],
    },
  ],
};
