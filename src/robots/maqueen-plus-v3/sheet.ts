/** Maqueen Plus V3: its page in the gallery. */
import type { RobotSheet } from '../robot';
import words from './words/sheet';
import firstDrive from './examples/first_drive.py?languages';

export const maqueenPlusV3Sheet: RobotSheet = {
  robot: 'maqueen-plus-v3',
  about: words.about,
  examples: [{ ...firstDrive, course: 'empty' }],
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
